#include "striate/agent/plugins/plugin_body.hpp"

#include "striate/agent/plugins/body_registry.hpp"
#include "striate/agent/plugins/robot_plugins.hpp"
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

}  // namespace

BodySource named_body(const std::string& robot_file) {
  const NamedBody body = body_in(robot_file);
  if (body.name.empty()) return real_pioneer();
  return {.wake = [body](const RobotSettings& settings) -> Body {
    const BodyEntry& entry = *body_registry().find(body.name);
    return {.robot = entry.make(body.settings, simulated_robot(settings)), .place = body.name};
  }};
}

}  // namespace striate::agent
