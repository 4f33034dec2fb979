#include <fmt/format.h>

#include <map>
#include <memory>
#include <utility>

#include "striate/base/user_error.hpp"
#include "striate/behaviours/registry.hpp"
#include "striate/python/definitions.hpp"
#include "striate/python/failures.hpp"
#include "striate/python/lent_memory.hpp"
#include "striate/python/python_names.hpp"
#include "striate/python/wishes.hpp"
#include "striate/tasks/reader/step_reader.hpp"

namespace striate::python {
namespace {

using behaviours::Behaviour;
using behaviours::Motors;
using behaviours::Wish;

/// The arguments of one step, read as any other action's are.
struct GivenArguments {
  std::vector<ArgumentDefinition> all;
};

template <class V>
void visit(V& v, GivenArguments& given) {
  using Kind = ArgumentDefinition::Kind;
  for (ArgumentDefinition& one : given.all) {
    const char* name = one.name.c_str();
    const char* help = one.help.c_str();
    if (one.kind == Kind::number) v.number(name, one.number, one.unit, one.range, help);
    if (one.kind == Kind::integer) v.integer(name, one.integer, one.range, help);
    if (one.kind == Kind::flag) v.flag(name, one.flag, help);
    if (one.kind == Kind::text) v.text(name, one.text, help);
    if (one.kind == Kind::choice) v.choice(name, one.integer, one.choices, help);
  }
}

py::object value_of(const ArgumentDefinition& one) {
  switch (one.kind) {
    case ArgumentDefinition::Kind::number:
      return py::float_(one.number);
    case ArgumentDefinition::Kind::integer:
      return py::int_(one.integer);
    case ArgumentDefinition::Kind::flag:
      return py::bool_(one.flag);
    case ArgumentDefinition::Kind::text:
      return py::str(one.text);
    default:
      return py::str(one.choices.at(static_cast<std::size_t>(one.integer)));
  }
}

/// A behaviour that Python wrote. Each call takes the interpreter's lock.
class PythonBehaviour final : public Behaviour {
 public:
  /// @param self none: its arguments were wrong, and it is not run
  PythonBehaviour(const BehaviourDefinition& definition, py::object self)
      : who_(fmt::format("the behaviour '{}'", definition.name)),
        self_(std::move(self)),
        motors_(definition.motors),
        ends_by_itself_(definition.ends_by_itself),
        can_fail_(definition.can_fail) {}
  ~PythonBehaviour() override {
    const py::gil_scoped_acquire lock;
    self_ = py::object();
  }
  PythonBehaviour(const PythonBehaviour&) = delete;
  PythonBehaviour& operator=(const PythonBehaviour&) = delete;

  void start(const memory::ShortTermMemory& memory) override {
    in_python(who_, [&] {
      if (!py::hasattr(self_, "start")) return;
      const MemoryLoan loan(memory);
      self_.attr("start")(loan.lent());
    });
  }

  Wish tick(const memory::ShortTermMemory& memory) override {
    return in_python(who_, [&] {
      const MemoryLoan loan(memory);
      const py::object wished = self_.attr("tick")(loan.lent());
      try {
        return wish_of(returned_wish(wished, who_ + ": tick()"), memory);
      } catch (const UserError& error) {
        throw py::value_error(error.what());
      }
    });
  }

  bool halt(const memory::ShortTermMemory& memory) override {
    return in_python(who_, [&] {
      if (!py::hasattr(self_, "halt")) return true;
      const MemoryLoan loan(memory);
      const py::object done = self_.attr("halt")(loan.lent());
      return done.is_none() || py::bool_(done);
    });
  }

  [[nodiscard]] Motors motors() const override { return motors_; }
  [[nodiscard]] bool ends_by_itself() const override { return ends_by_itself_; }
  [[nodiscard]] bool can_fail() const override { return can_fail_; }

 private:
  std::string who_;
  py::object self_;
  Motors motors_;
  bool ends_by_itself_;
  bool can_fail_;
};

std::unique_ptr<Behaviour> make_behaviour(const BehaviourDefinition& definition,
                                          const config::Node& given,
                                          config::Diagnostics& diagnostics,
                                          const RobotDescription& robot) {
  const std::size_t before = diagnostics.count();
  GivenArguments arguments{definition.arguments};
  const config::Node map = behaviours::detail::with_main(given, definition.main);
  config::SettingsReader reader(map, definition.name, diagnostics);
  visit(reader, arguments);
  for (const std::string& key : definition.required) reader.require(key);
  reader.finish();
  const py::gil_scoped_acquire lock;
  py::object self;
  if (diagnostics.count() == before) {
    py::dict values;
    for (const ArgumentDefinition& one : arguments.all) values[py::str(one.name)] = value_of(one);
    self = definition.make(values, robot);
  }
  return std::make_unique<PythonBehaviour>(definition, std::move(self));
}

/// Never destroyed: Python's objects must not outlive the interpreter in here.
std::map<std::string, BehaviourDefinition>& behaviours_of_python() {
  static auto* all = new std::map<std::string, BehaviourDefinition>();
  return *all;
}

behaviours::BehaviourEntry entry_of(const BehaviourDefinition& definition) {
  behaviours::BehaviourEntry entry;
  entry.name = definition.name;
  entry.help = definition.help;
  entry.main = definition.main;
  entry.required = definition.required;
  entry.make = [&definition](const config::Node& given, config::Diagnostics& diagnostics,
                             const RobotDescription& robot) {
    return make_behaviour(definition, given, diagnostics, robot);
  };
  entry.parameters = [&definition] {
    GivenArguments arguments{definition.arguments};
    config::SettingsPrinter printer;
    visit(printer, arguments);
    return printer.lines();
  };
  return entry;
}

}  // namespace

void define(BehaviourDefinition definition) {
  const std::string name = definition.name;
  const bool ours = behaviours_of_python().contains(name);
  check_new_name(
      "behaviour", name,
      tasks::is_word_of_steps(name) || (!ours && behaviours::find_behaviour(name) != nullptr));
  BehaviourDefinition& kept = behaviours_of_python()[name];
  kept = std::move(definition);
  if (!ours) (void)behaviours::enroll(entry_of(kept));
}

}  // namespace striate::python
