#include "striate/agent/plugins/plugin.hpp"

/// Linked with a copy of its own of the library that has the table of behaviours, and goes to that
/// table by itself. The program shows the name only where both are one table.
namespace {

class Idle final : public striate::behaviours::Behaviour {
 public:
  struct Settings {};
  Idle(const Settings& /*settings*/, const striate::RobotDescription& /*robot*/) {}
  void start(const striate::memory::ShortTermMemory& /*memory*/) override {}
  striate::behaviours::Wish tick(const striate::memory::ShortTermMemory& memory) override {
    return striate::behaviours::standing_wish(memory, "idles");
  }
};

template <class V>
void visit(V& /*v*/, Idle::Settings& /*s*/) {}

void enroll(striate::agent::PluginRegistrar& plugin) {
  plugin.add(striate::behaviours::behaviour_entry<Idle>("handed_in", "through the registrar"));
  (void)striate::behaviours::enroll(
      striate::behaviours::behaviour_entry<Idle>("by_itself", "through its own library"));
}

}  // namespace

STRIATE_PLUGIN("own_copy", enroll)
