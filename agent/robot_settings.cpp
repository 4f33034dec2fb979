#include "striate/agent/robot_settings.hpp"

#include <fmt/format.h>

#include "striate/config/yaml.hpp"

namespace striate::agent {
namespace {

RobotSettings read(const config::Node& root, config::Diagnostics& diagnostics) {
  RobotSettings settings;
  if (!diagnostics.none()) return settings;
  config::SettingsReader reader(root, "the robot settings", diagnostics);
  visit(reader, settings);
  reader.finish();
  return settings;
}

/// The line where a dotted key stands in the file, 0 if it does not.
int line_of(const config::Node& root, const std::string& dotted_key) {
  const config::Node* node = &root;
  int line = 0;
  std::size_t begin = 0;
  while (begin <= dotted_key.size()) {
    const std::size_t end = std::min(dotted_key.find('.', begin), dotted_key.size());
    const auto* entry = node->find(dotted_key.substr(begin, end - begin));
    if (entry == nullptr) return 0;
    node = &entry->value;
    line = entry->key_place.line;
    begin = end + 1;
  }
  return line;
}

}  // namespace

RobotSettings load_robot_settings(const std::string& file, std::string* warnings) {
  if (file.empty()) return {};
  config::Diagnostics diagnostics(file);
  const config::Node root = load_yaml(diagnostics);
  RobotSettings settings = read(root, diagnostics);
  diagnostics.throw_if_any();
  if (warnings != nullptr) *warnings = diagnostics.warnings();
  return settings;
}

RobotDescription simulated_robot(const RobotSettings& settings) {
  RobotDescription robot = described_by(settings.robot);
  robot.camera_height_m = settings.camera.height_above_floor_m;
  robot.camera_forward_m = settings.camera.forward_of_axle_m;
  robot.view_rad = settings.camera.field_rad;
  robot.resting_tilt_rad = settings.camera.resting_tilt_rad;
  return robot;
}

std::vector<SettingInForce> settings_in_force(const std::string& file) {
  RobotSettings settings = load_robot_settings(file);
  config::Node root;
  if (!file.empty()) {
    config::Diagnostics diagnostics(file);
    root = load_yaml(diagnostics);
  }
  config::SettingsPrinter printer;
  visit(printer, settings);
  std::vector<SettingInForce> list;
  for (const config::SettingLine& line : printer.lines()) {
    const int number = line_of(root, line.key);
    list.push_back({line, number == 0 ? "default" : fmt::format("{}:{}", file, number)});
  }
  return list;
}

}  // namespace striate::agent
