#include "striate/agent/plugins/plugin.hpp"

/// Uses something that neither it nor the program has.
int forgotten_at_linking();

namespace {

void enroll(striate::agent::PluginRegistrar& /*plugin*/) {
  (void)forgotten_at_linking();
}

}  // namespace

STRIATE_PLUGIN("unresolved", enroll)
