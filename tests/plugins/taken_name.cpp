#include "striate/agent/plugins/plugin.hpp"

/// What a plugin must not do: a name that Striate has, after one that would have been good.
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
  plugin.add(striate::behaviours::behaviour_entry<Idle>("idle", "does nothing"));
  plugin.add(striate::behaviours::behaviour_entry<Idle>(STRIATE_TEST_NAME, "has no right to it"));
}

}  // namespace

STRIATE_PLUGIN("taken_name", enroll)
