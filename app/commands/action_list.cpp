#include "striate/app/commands/action_list.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "striate/app/command_line/mistakes.hpp"
#include "striate/base/user_error.hpp"
#include "striate/tasks/condition_registry.hpp"

namespace striate::app {
namespace {

using nlohmann::ordered_json;

bool is_required(const behaviours::BehaviourEntry& behaviour, const std::string& key) {
  return std::find(behaviour.required.begin(), behaviour.required.end(), key) !=
         behaviour.required.end();
}

/// Numbers of many digits, which come from radians, with four: "60.00014031 deg" as "60 deg".
std::string readable(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t end = std::min(text.find_first_not_of("0123456789.", i), text.size());
    const std::string digits = text.substr(i, end - i);
    const bool long_number = digits.size() > 7 && digits.find("..") == std::string::npos &&
                             digits.find('.') != std::string::npos;
    out += long_number ? fmt::format("{:.4g}", std::stod(digits)) : digits;
    if (end < text.size()) out += text[end];
    i = end + 1;
  }
  return out;
}

std::string allowed_of(const tasks::ConditionEntry& condition) {
  if (condition.make_of != nullptr && condition.key.empty()) return "a landmark";
  return fmt::format("{} .. {}", config::print_quantity(condition.range.low, condition.unit),
                     config::print_quantity(condition.range.high, condition.unit));
}

ordered_json json_of(const behaviours::BehaviourEntry& behaviour) {
  ordered_json json = {{"name", behaviour.name}, {"help", behaviour.help}};
  json["parameters"] = ordered_json::array();
  for (const config::SettingLine& line : behaviour.parameters()) {
    ordered_json one = {{"name", line.key}, {"help", line.help}, {"allowed", line.allowed}};
    if (is_required(behaviour, line.key)) {
      one["required"] = true;
    } else {
      one["default"] = line.value;
    }
    json["parameters"].push_back(std::move(one));
  }
  json["example"] = "- " + example_of(behaviour);
  return json;
}

ordered_json json_of(const tasks::ConditionEntry& condition) {
  return {{"name", condition.name},
          {"help", condition.help},
          {"allowed", allowed_of(condition)},
          {"example", fmt::format("until: {{{}: {}}}", condition.name, condition.example)}};
}

std::string text_of(const behaviours::BehaviourEntry& behaviour) {
  std::string text =
      fmt::format("  {}: {}\n      - {}\n", behaviour.name, behaviour.help, example_of(behaviour));
  for (const config::SettingLine& line : behaviour.parameters()) {
    const std::string value =
        is_required(behaviour, line.key) ? "(must be given)" : readable(line.value);
    text += fmt::format("      {:24} {:16} {} ({})\n", line.key, value, line.help,
                        readable(line.allowed));
  }
  return text;
}

std::string text_of(const tasks::ConditionEntry& condition) {
  const std::string example = fmt::format("{{{}: {}}}", condition.name, condition.example);
  return fmt::format("  {:34} {} ({})\n", example, condition.help, allowed_of(condition));
}

/// @throws UserError with the nearest name; "" is all of them
void check_known(const std::string& name) {
  std::vector<std::string> names;
  for (const behaviours::BehaviourEntry& behaviour : behaviours::behaviour_registry())
    names.push_back(behaviour.name);
  for (const tasks::ConditionEntry& condition : tasks::condition_registry())
    names.push_back(condition.name);
  if (name.empty() || std::find(names.begin(), names.end(), name) != names.end()) return;
  throw UserError(unknown_text("action or condition", name, names, "striate task actions"));
}

}  // namespace

std::string example_of(const behaviours::BehaviourEntry& behaviour) {
  constexpr int kShown = 3;  // parameters: what fits beside a name in a line of 80
  std::string arguments;
  int shown = 0;
  for (const config::SettingLine& line : behaviour.parameters()) {
    const bool required = is_required(behaviour, line.key);
    const bool nested = line.key.find('.') != std::string::npos;
    if (nested || (shown >= kShown && !required)) continue;
    if (line.value.empty() && !required) continue;
    ++shown;
    const std::string value = required && line.value.empty() ? "book" : readable(line.value);
    arguments += fmt::format("{}{}: {}", arguments.empty() ? "" : ", ", line.key, value);
  }
  return fmt::format("{}: {{{}}}", behaviour.name, arguments);
}

ordered_json actions_as_json(const std::string& only) {
  check_known(only);
  ordered_json json;
  json["actions"] = ordered_json::array();
  for (const behaviours::BehaviourEntry& behaviour : behaviours::behaviour_registry()) {
    if (only.empty() || only == behaviour.name) json["actions"].push_back(json_of(behaviour));
  }
  json["conditions"] = ordered_json::array();
  for (const tasks::ConditionEntry& condition : tasks::condition_registry()) {
    if (only.empty() || only == condition.name) json["conditions"].push_back(json_of(condition));
  }
  return json;
}

std::string actions_as_text(const std::string& only) {
  check_known(only);
  std::string text =
      only.empty() ? "Actions (a parameter that is left out has the value shown):\n" : "";
  for (const behaviours::BehaviourEntry& behaviour : behaviours::behaviour_registry()) {
    if (only.empty()) text += "\n" + text_of(behaviour);
    if (only == behaviour.name) return text_of(behaviour);
  }
  text +=
      "\nConditions, for until, only_if, unless, pause_if and fail_if; joined by\n"
      "{all: [{...}, {...}]}, {any: [{...}, {...}]} and {not: {...}}:\n\n";
  for (const tasks::ConditionEntry& condition : tasks::condition_registry()) {
    text += text_of(condition);
    if (only == condition.name) return text_of(condition);
  }
  return text;
}

}  // namespace striate::app
