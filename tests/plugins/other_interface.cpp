#include <cstdlib>

#include "striate/agent/plugins/plugin.hpp"

/// Says that it is built otherwise than this Striate. Nothing else of it may be called or read.
namespace {

void enroll(striate::agent::PluginRegistrar& /*plugin*/) {
  std::abort();
}

}  // namespace

extern "C" const striate::agent::PluginInfo* striate_plugin() {
  static constexpr striate::agent::PluginInfo info{STRIATE_TEST_INTERFACE, STRIATE_TEST_VERSION,
                                                   STRIATE_TEST_ABI,       STRIATE_TEST_LAYOUT,
                                                   "other_interface",      enroll};
  return &info;
}
