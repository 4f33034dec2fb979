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
#include "striate/python/truth.hpp"
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
      return done.is_none() || is_true(done);
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

/// What Python wrote, by name, under the interpreter's lock. Never destroyed: Python's objects must
/// not outlive the interpreter in here.
std::map<std::string, std::shared_ptr<const BehaviourDefinition>>& behaviours_of_python() {
  static auto* all = new std::map<std::string, std::shared_ptr<const BehaviourDefinition>>();
  return *all;
}

std::unique_ptr<Behaviour> make_behaviour(const std::string& name, const config::Node& given,
                                          config::Diagnostics& diagnostics,
                                          const RobotDescription& robot) {
  const py::gil_scoped_acquire lock;
  // A share of it: what is made may put another in its place meanwhile.
  const std::shared_ptr<const BehaviourDefinition> definition = behaviours_of_python().at(name);
  const std::size_t before = diagnostics.count();
  GivenArguments arguments{definition->arguments};
  const config::Node map = behaviours::detail::with_main(given, definition->main);
  config::SettingsReader reader(map, name, diagnostics);
  visit(reader, arguments);
  for (const std::string& key : definition->required) reader.require(key);
  reader.finish();
  py::object self;
  if (diagnostics.count() == before) {
    py::dict values;
    for (const ArgumentDefinition& one : arguments.all) values[py::str(one.name)] = value_of(one);
    self = definition->make(values, robot);
  }
  return std::make_unique<PythonBehaviour>(*definition, std::move(self));
}

std::vector<config::SettingLine> parameters_of(const std::string& name) {
  const py::gil_scoped_acquire lock;
  GivenArguments arguments{behaviours_of_python().at(name)->arguments};
  config::SettingsPrinter printer;
  visit(printer, arguments);
  return printer.lines();
}

behaviours::BehaviourEntry entry_of(const BehaviourDefinition& definition) {
  const std::string name = definition.name;
  behaviours::BehaviourEntry entry;
  entry.name = name;
  entry.help = definition.help;
  entry.main = definition.main;
  entry.required = definition.required;
  entry.make = [name](const config::Node& given, config::Diagnostics& diagnostics,
                      const RobotDescription& robot) {
    return make_behaviour(name, given, diagnostics, robot);
  };
  entry.parameters = [name] { return parameters_of(name); };
  return entry;
}

}  // namespace

void define(BehaviourDefinition definition) {
  const std::string name = definition.name;
  const bool ours = behaviours_of_python().contains(name);
  check_new_name(
      "behaviour", name,
      tasks::is_word_of_steps(name) || (!ours && behaviours::find_behaviour(name) != nullptr));
  behaviours::BehaviourEntry entry = entry_of(definition);
  behaviours_of_python()[name] = std::make_shared<const BehaviourDefinition>(std::move(definition));
  if (!ours) (void)behaviours::enroll(std::move(entry));
}

}  // namespace striate::python
