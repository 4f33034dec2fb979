#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "striate/base/user_error.hpp"
#include "striate/python/definitions.hpp"
#include "striate/python/failures.hpp"
#include "striate/python/lent_memory.hpp"
#include "striate/python/python_names.hpp"
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
      const py::object holds = self_.attr("holds")(loan.lent());
      const int truth = PyObject_IsTrue(holds.ptr());
      if (truth < 0) throw py::error_already_set();
      return truth == 1;
    });
  }

 private:
  std::string who_;
  py::object self_;
};

/// An entry of the table is made by a plain function, which knows nothing but the limit. So there
/// is one for each place in here. By hand: more conditions than a script has ever named.
constexpr std::size_t kMostConditions = 128;
using Maker = std::unique_ptr<tasks::Condition> (*)(double);

/// Never destroyed: Python's objects must not outlive the interpreter in here.
std::vector<ConditionDefinition>& conditions_of_python() {
  static auto* all = new std::vector<ConditionDefinition>();
  return *all;
}

template <std::size_t kPlace>
std::unique_ptr<tasks::Condition> make_condition(double limit) {
  const py::gil_scoped_acquire lock;
  const ConditionDefinition& definition = conditions_of_python().at(kPlace);
  return std::make_unique<PythonCondition>(definition.name, definition.make(limit));
}

template <std::size_t... kPlaces>
constexpr std::array<Maker, sizeof...(kPlaces)> makers(std::index_sequence<kPlaces...> /*places*/) {
  return {make_condition<kPlaces>...};
}

}  // namespace

void define(ConditionDefinition definition) {
  static constexpr auto kMakers = makers(std::make_index_sequence<kMostConditions>());
  std::vector<ConditionDefinition>& all = conditions_of_python();
  const auto old = std::ranges::find(all, definition.name, &ConditionDefinition::name);
  check_new_name("condition", definition.name,
                 old == all.end() && tasks::find_condition(definition.name) != nullptr);
  if (old != all.end()) {
    *old = std::move(definition);
    return;
  }
  if (all.size() == kMostConditions) {
    throw UserError(fmt::format("a condition '{}': Python has {} already, and no more can be added",
                                definition.name, kMostConditions));
  }
  tasks::ConditionEntry entry{definition.name,  definition.help,    definition.unit,
                              definition.range, definition.example, kMakers[all.size()]};
  all.push_back(std::move(definition));
  (void)tasks::enroll(std::move(entry));
}

}  // namespace striate::python
