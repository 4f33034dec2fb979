#include "striate/agent/robot_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "striate/config/yaml.hpp"

namespace striate::agent {
namespace {

RobotSettings read(config::Node root, config::Diagnostics& diagnostics, PluginLines lines) {
  RobotSettings settings;
  if (!diagnostics.none()) return settings;
  (void)take_plugins(root, diagnostics, lines);
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

/// The body that is named, with its settings; nothing where none is.
std::vector<config::SettingLine> body_lines(config::Node root, const std::string& file) {
  config::Diagnostics unheard(file);  // told before
  const NamedBody body = take_plugins(root, unheard, PluginLines::load);
  if (body.name.empty()) return {};
  std::vector<config::SettingLine> lines{
      {"body", body.name, "pioneer, or one of a plugin", "who is driven"}};
  for (config::SettingLine& line : settings_of(body)) {
    line.key = fmt::format("body.{}.{}", body.name, line.key);
    lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace

RobotSettings load_robot_settings(const std::string& file, std::string* warnings,
                                  PluginLines lines) {
  if (file.empty()) return {};
  config::Diagnostics diagnostics(file);
  const config::Node root = load_yaml(diagnostics);
  RobotSettings settings = read(root, diagnostics, lines);
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
  std::vector<config::SettingLine> lines = body_lines(root, file);
  lines.insert(lines.end(), printer.lines().begin(), printer.lines().end());
  std::vector<SettingInForce> list;
  for (const config::SettingLine& line : lines) {
    const int number = line_of(root, line.key);
    list.push_back({line, number == 0 ? "default" : fmt::format("{}:{}", file, number)});
  }
  return list;
}

}  // namespace striate::agent
