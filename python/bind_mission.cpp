#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <chrono>
#include <filesystem>
#include <utility>

#include "striate/agent/recall/memory_state.hpp"
#include "striate/python/bindings.hpp"
#include "striate/python/json_objects.hpp"
#include "striate/python/python_mission.hpp"
#include "striate/python/running_missions.hpp"
#include "striate/python/shown_cycle.hpp"
#include "striate/python/texts.hpp"
#include "striate/python/wishes.hpp"

namespace striate::python {
namespace {

namespace fs = std::filesystem;
/// By hand: a mission ends within its cycle, and then closes memory and recording.
constexpr std::chrono::milliseconds kEndPatience{20'000};

using CycleClass = py::class_<ShownCycle, std::shared_ptr<ShownCycle>>;

void add_facts(CycleClass& cycle) {
  cycle.def_readonly("number", &ShownCycle::number, "Of the cycle, from 1.")
      .def_property_readonly("senses", &ShownCycle::senses,
                             "What was felt. With images where it is asked for while the callback "
                             "runs.")
      .def_property_readonly(
          "percept", [](const ShownCycle& c) { return c.percept; },
          "What was seen in the newest image.")
      .def_property_readonly(
          "wish", [](const ShownCycle& c) { return asked_of(c.wish); },
          "What the behaviour wanted.")
      .def_property_readonly(
          "sent", [](const ShownCycle& c) { return c.sent; },
          "What the safety limiter let through to the motors.")
      .def_property_readonly(
          "driver", [](const ShownCycle& c) { return text_of(c.driver); },
          "Whose wish it was that drove: 'behaviour', 'pilot', 'guard', ...")
      .def_property_readonly(
          "limited_by", [](const ShownCycle& c) { return text_of(c.limited_by); },
          "What held the robot back, in words; '': nothing.")
      .def_property_readonly(
          "action", [](const ShownCycle& c) { return text_of(c.action); },
          "Of the task that ran; '': none.")
      .def_property_readonly(
          "doing", [](const ShownCycle& c) { return text_of(c.doing); },
          "What the robot does and what holds it back, in words.")
      .def_property_readonly(
          "hold", [](const ShownCycle& c) { return text_of(c.hold); },
          "Why the body's own gate holds the robot; '': it does not.")
      .def_readonly("waits_for_reset", &ShownCycle::waits_for_reset,
                    "Whether that lasts until reset().")
      .def_readonly("progress_m", &ShownCycle::progress_m,
                    "Along the corridor's axis since the start.");
}

void add_lent(CycleClass& cycle) {
  cycle
      .def_property_readonly(
          "memory", [](const ShownCycle& c) { return c.memory(); },
          "Short-term memory, lent for the callback.")
      .def(
          "memory_state",
          [](const ShownCycle& c) {
            const agent::Mission& mission = c.mission();
            return object_of(
                agent::memory_state(mission.cycle(), mission.executive(), mission.cycles()));
          },
          "Short-term memory as a dict, as `striate recall --json` tells it. Raises RuntimeError "
          "when the callback is over.")
      .def(
          "reset", [](const ShownCycle& c) { c.mission().reset_body(); },
          "Somebody has looked at the robot and lets it go on: ends what its gate has latched. "
          "Raises RuntimeError when the callback is over.");
}

}  // namespace

void bind_mission(py::module_& module) {
  CycleClass cycle(module, "Cycle", "One cycle of a mission, for its callback.");
  add_facts(cycle);
  add_lent(cycle);
  module.def(
      "_run",
      [](const fs::path& task, const fs::path& world, std::uint64_t seed, const fs::path& robot,
         const fs::path& memory, const fs::path& record, const fs::path& result,
         const std::string& baseline, const std::map<std::string, std::string>& variables,
         bool emergency, bool real_time, bool hears_signals, const std::optional<Pose2>& start,
         py::object each_cycle, py::object pilot) {
        MissionRequest request{task.string(),
                               world.string(),
                               seed,
                               robot.string(),
                               memory.string(),
                               record.string(),
                               result.string(),
                               baseline,
                               variables,
                               emergency,
                               real_time,
                               hears_signals,
                               start,
                               std::move(each_cycle),
                               std::move(pilot)};
        const MissionOutcome outcome = run_mission(request);
        return py::make_tuple(object_of(agent::to_json(outcome.result)), text_of(outcome.json),
                              text_of(outcome.losses), text_of(outcome.notices));
      },
      py::arg("task"), py::arg("world"), py::arg("seed"), py::arg("robot"), py::arg("memory"),
      py::arg("record"), py::arg("result"), py::arg("baseline"), py::arg("variables"),
      py::arg("emergency"), py::arg("real_time"), py::arg("hears_signals"), py::arg("start"),
      py::arg("each_cycle"), py::arg("pilot"));
  module.def(
      "_end_missions", [] { return running_missions().end(kEndPatience); },
      py::call_guard<py::gil_scoped_release>());
}

}  // namespace striate::python
