#include "striate/agent/plugins/plugin_body.hpp"

#include "striate/agent/plugins/body_registry.hpp"
#include "striate/agent/plugins/robot_plugins.hpp"
#include "striate/agent/rosbridge_body.hpp"
#include "striate/base/user_error.hpp"
#include "striate/config/yaml.hpp"

namespace striate::agent {
namespace {

NamedBody body_in(const std::string& robot_file) {
  if (robot_file.empty()) return {};
  config::Diagnostics diagnostics(robot_file);
  config::Node root = config::load_yaml(diagnostics);
  diagnostics.throw_if_any();
  NamedBody body = take_plugins(root, diagnostics, PluginLines::load);
  diagnostics.throw_if_any();
  return body;
}

/// Who is behind the places in the settings: a Pioneer's devices, or a rosbridge server.
Body body_at_its_place(RobotSettings& settings) {
  if (settings.rosbridge.url.empty()) return real_pioneer().wake(settings);
  if (!settings.pioneer.devices.base.empty()) {
    throw UserError(
        "striate run: --robot FILE names two robots, one at pioneer.devices.base and one at "
        "rosbridge.url\n  hint: leave one of them out");
  }
  return robot_behind_rosbridge().wake(settings);
}

}  // namespace

BodySource named_body(const std::string& robot_file) {
  const NamedBody body = body_in(robot_file);
  if (body.name.empty()) return {.wake = body_at_its_place};
  return {.wake = [body](const RobotSettings& settings) -> Body {
    const BodyEntry& entry = *body_registry().find(body.name);
    return {.robot = entry.make(body.settings, simulated_robot(settings)), .place = body.name};
  }};
}

}  // namespace striate::agent
