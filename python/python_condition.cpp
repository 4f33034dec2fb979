#include <fmt/format.h>

#include <map>
#include <memory>
#include <string>
#include <utility>

#include "striate/python/definitions.hpp"
#include "striate/python/failures.hpp"
#include "striate/python/lent_memory.hpp"
#include "striate/python/python_names.hpp"
#include "striate/python/truth.hpp"
#include "striate/tasks/condition_registry.hpp"

namespace striate::python {
namespace {

/// A condition that Python wrote. Each call takes the interpreter's lock.
class PythonCondition final : public tasks::Condition {
 public:
  PythonCondition(const std::string& name, py::object self)
      : who_(fmt::format("the condition '{}'", name)), self_(std::move(self)) {}
  ~PythonCondition() override {
    const py::gil_scoped_acquire lock;
    self_ = py::object();
  }
  PythonCondition(const PythonCondition&) = delete;
  PythonCondition& operator=(const PythonCondition&) = delete;

  void start(const memory::ShortTermMemory& memory) override {
    in_python(who_, [&] {
      if (!py::hasattr(self_, "start")) return;
      const MemoryLoan loan(memory);
      self_.attr("start")(loan.lent());
    });
  }

  [[nodiscard]] bool holds(const memory::ShortTermMemory& memory) const override {
    return in_python(who_, [&] {
      const MemoryLoan loan(memory);
      return is_true(self_.attr("holds")(loan.lent()));
    });
  }

 private:
  std::string who_;
  py::object self_;
};

/// What Python wrote, by name, under the interpreter's lock. Never destroyed: Python's objects must
/// not outlive the interpreter in here.
std::map<std::string, std::shared_ptr<const ConditionDefinition>>& conditions_of_python() {
  static auto* all = new std::map<std::string, std::shared_ptr<const ConditionDefinition>>();
  return *all;
}

std::unique_ptr<tasks::Condition> make_condition(const std::string& name, double limit) {
  const py::gil_scoped_acquire lock;
  // A share of it: what is made may put another in its place meanwhile.
  const std::shared_ptr<const ConditionDefinition> definition = conditions_of_python().at(name);
  return std::make_unique<PythonCondition>(name, definition->make(limit));
}

}  // namespace

void define(ConditionDefinition definition) {
  const std::string name = definition.name;
  const bool ours = conditions_of_python().contains(name);
  check_new_name("condition", name, !ours && tasks::find_condition(name) != nullptr);
  tasks::ConditionEntry entry{name,
                              definition.help,
                              definition.unit,
                              definition.range,
                              definition.example,
                              [name](double limit) { return make_condition(name, limit); }};
  conditions_of_python()[name] = std::make_shared<const ConditionDefinition>(std::move(definition));
  if (!ours) (void)tasks::enroll(std::move(entry));
}

}  // namespace striate::python
