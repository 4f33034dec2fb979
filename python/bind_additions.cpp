#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "striate/agent/plugins/load_plugin.hpp"
#include "striate/base/user_error.hpp"
#include "striate/behaviours/registry.hpp"
#include "striate/config/diagnostics.hpp"
#include "striate/config/node.hpp"
#include "striate/config/quantity.hpp"
#include "striate/python/bindings.hpp"
#include "striate/python/definitions.hpp"
#include "striate/python/files.hpp"
#include "striate/python/python_names.hpp"
#include "striate/python/wishes.hpp"
#include "striate/tasks/condition_registry.hpp"

namespace striate::python {
namespace {

using config::Unit;

template <class Value, std::size_t kCount>
Value named(const std::array<std::pair<const char*, Value>, kCount>& all, const std::string& name,
            const char* what) {
  std::string known;
  for (const auto& [text, value] : all) {
    if (name == text) return value;
    known += known.empty() ? text : fmt::format(", {}", text);
  }
  throw UserError(fmt::format("{} '{}': choose one of {}", what, name, known));
}

Unit unit_named(const std::string& name) {
  static constexpr std::array<std::pair<const char*, Unit>, 11> kUnits{
      {{"none", Unit::none},
       {"length", Unit::length},
       {"duration", Unit::duration},
       {"angle", Unit::angle},
       {"speed", Unit::speed},
       {"turn_rate", Unit::turn_rate},
       {"acceleration", Unit::acceleration},
       {"turn_acceleration", Unit::turn_acceleration},
       {"rate", Unit::rate},
       {"fraction", Unit::fraction},
       {"pixels", Unit::pixels}}};
  return named(kUnits, name, "unit");
}

behaviours::Motors motors_named(const std::string& name) {
  using behaviours::Motors;
  static constexpr std::array<std::pair<const char*, Motors>, 4> kMotors{
      {{"nothing", Motors::nothing},
       {"wheels", Motors::wheels},
       {"head", Motors::head},
       {"both", Motors::both}}};
  return named(kMotors, name, "motors");
}

/// The kind of an argument is that of its default. @param one a striate.Argument, which has checked
/// itself @throws UserError for a name or a unit that is none
ArgumentDefinition argument_of(const std::string& name, const py::handle& one) {
  using Kind = ArgumentDefinition::Kind;
  check_new_name("argument", name, false);
  ArgumentDefinition argument;
  argument.name = name;
  argument.unit = unit_named(one.attr("unit").cast<std::string>());
  argument.range = {one.attr("low").cast<double>(), one.attr("high").cast<double>()};
  argument.help = one.attr("help").cast<std::string>();
  argument.choices = one.attr("choices").cast<std::vector<std::string>>();
  const py::object value = one.attr("default");
  if (!argument.choices.empty()) {
    argument.kind = Kind::choice;
    const auto found = std::ranges::find(argument.choices, value.cast<std::string>());
    argument.integer = static_cast<int>(found - argument.choices.begin());
  } else if (py::isinstance<py::bool_>(value)) {
    argument.kind = Kind::flag;
    argument.flag = value.cast<bool>();
  } else if (py::isinstance<py::int_>(value)) {
    argument.kind = Kind::integer;
    argument.integer = value.cast<int>();
  } else if (py::isinstance<py::str>(value)) {
    argument.kind = Kind::text;
    argument.text = value.cast<std::string>();
  } else {
    argument.number = value.cast<double>();
  }
  return argument;
}

void add_behaviour(const std::string& name, py::object make, const std::string& help,
                   const py::dict& arguments, const std::string& main,
                   std::vector<std::string> required, const std::string& motors,
                   bool ends_by_itself, bool can_fail) {
  BehaviourDefinition definition{
      name,           help,    std::move(make), {}, main, std::move(required), motors_named(motors),
      ends_by_itself, can_fail};
  std::vector<std::string> known;
  for (const auto& [key, one] : arguments) {
    known.push_back(key.cast<std::string>());
    definition.arguments.push_back(argument_of(known.back(), one));
  }
  std::vector<std::string> asked = definition.required;
  if (!main.empty()) asked.push_back(main);
  for (const std::string& key : asked) {
    if (std::ranges::find(known, key) != known.end()) continue;
    throw UserError(
        fmt::format("a behaviour '{}' without the argument '{}' that it names", name, key));
  }
  define(std::move(definition));
}

/// What lists show it with. @throws UserError where it is given and cannot be read
std::string example_of(const ConditionDefinition& definition, const std::string& given) {
  const config::Range& range = definition.range;
  if (given.empty()) {
    return config::print_quantity(std::clamp(1.0, range.low, range.high), definition.unit);
  }
  config::Node node;
  node.kind = config::Node::Kind::scalar;
  node.text = given;
  config::Diagnostics diagnostics("the example");
  if (!config::read_quantity(node, definition.unit, range, diagnostics)) {
    throw UserError(fmt::format("a condition '{}' with the example '{}': {}", definition.name,
                                given, diagnostics.list().front().message));
  }
  return given;
}

py::list names_of(const auto& table) {
  py::list names;
  for (const auto& entry : table) names.append(entry.name);
  return names;
}

}  // namespace

void bind_additions(py::module_& module) {
  bind_wish(module);
  module.def("_add_behaviour", &add_behaviour, py::arg("name"), py::arg("make"), py::arg("help"),
             py::arg("arguments"), py::arg("main"), py::arg("required"), py::arg("motors"),
             py::arg("ends_by_itself"), py::arg("can_fail"));
  module.def(
      "_add_condition",
      [](const std::string& name, py::object make, const std::string& help, const std::string& unit,
         double low, double high, const std::string& example) {
        ConditionDefinition definition{name,        help, std::move(make), unit_named(unit),
                                       {low, high}, ""};
        definition.example = example_of(definition, example);
        define(std::move(definition));
      },
      py::arg("name"), py::arg("make"), py::arg("help"), py::arg("unit"), py::arg("low"),
      py::arg("high"), py::arg("example"));
  module.def(
      "use_plugin",
      [](const std::filesystem::path& file) {
        open_to_plugins();
        agent::use_plugin(file.string());
      },
      py::arg("file"),
      "Loads a plugin, a shared object with behaviours, conditions, stages or bodies, as "
      "`--plugin` "
      "does. Its code runs with all rights of this process.\n\nRaises UserError where it does not "
      "fit.");
  module.def(
      "actions", [] { return names_of(behaviours::behaviour_registry()); },
      "Names of all actions that task scripts know: ours, then those that were added.");
  module.def(
      "conditions", [] { return names_of(tasks::condition_registry()); },
      "Names of all conditions that task scripts know.");
}

}  // namespace striate::python
