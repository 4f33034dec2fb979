#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <mutex>

#include "striate/agent/recall/memory_state.hpp"
#include "striate/agent/replay/replay_mission.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/replay/recording.hpp"
#include "striate/python/bindings.hpp"
#include "striate/python/felt.hpp"
#include "striate/python/json_objects.hpp"
#include "striate/python/texts.hpp"

namespace striate::python {
namespace {

namespace fs = std::filesystem;
using replay::RecordedCycle;
using replay::RecordedSetup;

/// Goes through a recording from its beginning.
class CycleReader {
 public:
  explicit CycleReader(const fs::path& file) : reader_(file.string()) {}

  std::shared_ptr<RecordedCycle> next() {
    auto cycle = std::make_shared<RecordedCycle>();
    bool found = false;
    {
      const py::gil_scoped_release unlocked;
      const std::lock_guard one_at_a_time(mutex_);
      found = reader_.next(*cycle);
    }
    if (!found) throw py::stop_iteration();
    return cycle;
  }

 private:
  replay::RecordingReader reader_;
  std::mutex mutex_;
};

py::dict dict_of(const std::vector<replay::NamedText>& texts) {
  py::dict dict;
  for (const auto& [name, text] : texts) dict[text_of(name)] = text_of(text);
  return dict;
}

/// A recording is opened anew for each that goes through it; only its head is kept.
struct OpenedRecording {
  fs::path file;   ///< as it was named
  fs::path place;  ///< where that is, whatever the process's folder becomes
  RecordedSetup setup;
};

OpenedRecording open_recording(const fs::path& file) {
  const py::gil_scoped_release unlocked;
  return {file, fs::absolute(file), replay::RecordingReader(file.string()).setup()};
}

/// As `striate recall`: memory is what the cycles before have made of it, so the recording is run
/// again up to there.
py::object recall(const OpenedRecording& recording, const std::optional<std::uint64_t>& cycle,
                  const std::optional<double>& at_s) {
  nlohmann::ordered_json state;
  {
    const py::gil_scoped_release unlocked;
    agent::ReplayMission mission({recording.place.string(), {}, {}});
    std::uint64_t last = 0;
    bool found = false;
    while (!found && mission.step()) {
      last = mission.recorded().number;
      found =
          (cycle && last >= *cycle) || (at_s && to_seconds(mission.recorded().senses.now) >= *at_s);
      if (last % 16 != 0) continue;  // by hand: a second or two of cycles between looks at Ctrl-C
      const py::gil_scoped_acquire locked;
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
    if (last == 0) throw UserError(recording.file.string() + ": has no cycle in it");
    if (!found && (cycle || at_s)) {
      throw UserError(recording.file.string() + ": ends with cycle " + std::to_string(last));
    }
    state = agent::memory_state(mission.cycle(), mission.executive(), last);
  }
  return object_of(state);
}

std::shared_ptr<Senses> senses_of(const std::shared_ptr<RecordedCycle>& cycle) {
  return {cycle, &cycle->senses};
}

void bind_cycle(py::module_& module) {
  using Shared = std::shared_ptr<RecordedCycle>;
  py::class_<RecordedCycle, Shared>(module, "RecordedCycle",
                                    "One cycle of a recording: what was felt and decided.")
      .def_readonly("number", &RecordedCycle::number,
                    "From 1; where numbers are missing, cycles were not kept.")
      .def_property_readonly("senses", &senses_of, "What was felt.")
      .def_property_readonly(
          "wish", [](const RecordedCycle& c) { return c.decision.wish; },
          "What the behaviour wanted.")
      .def_property_readonly(
          "sent", [](const RecordedCycle& c) { return c.decision.sent; },
          "What the safety limiter let through to the motors.")
      .def_property_readonly(
          "why", [](const RecordedCycle& c) { return text_of(c.decision.why); },
          "Of the wish, in words.")
      .def_property_readonly(
          "limited_by", [](const RecordedCycle& c) { return text_of(c.decision.limited_by); },
          "What held the robot back, in words, as it was recorded.")
      .def_property_readonly(
          "action", [](const RecordedCycle& c) { return text_of(c.decision.doing); },
          "Of the task that ran; '': none.");
}

}  // namespace

void bind_recording(py::module_& module) {
  bind_cycle(module);
  py::class_<CycleReader>(module, "_CycleReader")
      .def("__iter__", [](py::object self) { return self; })
      .def("__next__", &CycleReader::next);
  py::class_<OpenedRecording>(module, "Recording",
                              "A recorded run (`striate run --record`). Iterate over it for its "
                              "cycles.\n\nRaises UserError for a file that is none, or where it is "
                              "damaged.")
      .def(py::init(&open_recording), py::arg("file"))
      .def("__iter__",
           [](const OpenedRecording& recording) {
             return std::make_unique<CycleReader>(recording.place);
           })
      .def("recall", &recall, py::kw_only(), py::arg("cycle") = py::none(),
           py::arg("at_s") = py::none(),
           "What short-term memory held after a cycle, as `striate recall --json`: a dict. Without "
           "arguments, after the last one. The recording is run again up to there.\n\nRaises "
           "UserError where it ends before.")
      .def_property_readonly("file",
                             [](const OpenedRecording& r) { return text_of(r.file.string()); })
      .def_property_readonly("software",
                             [](const OpenedRecording& r) { return text_of(r.setup.software); })
      .def_property_readonly(
          "task", [](const OpenedRecording& r) { return text_of(r.setup.task); },
          "As it was named on the command line.")
      .def_property_readonly(
          "world", [](const OpenedRecording& r) { return text_of(r.setup.world); },
          "'': a real robot.")
      .def_property_readonly("seed", [](const OpenedRecording& r) { return r.setup.seed; })
      .def_property_readonly(
          "robot", [](const OpenedRecording& r) { return r.setup.robot; }, "Its shape and limits.")
      .def_property_readonly(
          "settings", [](const OpenedRecording& r) { return dict_of(r.setup.settings); },
          "All that were in force: key to value, as printed.")
      .def_property_readonly(
          "variables", [](const OpenedRecording& r) { return dict_of(r.setup.variables); },
          "Given to the task from outside.")
      .def_property_readonly(
          "task_files", [](const OpenedRecording& r) { return dict_of(r.setup.task_files); },
          "Name to text: the task first, then those that it uses.");
}

}  // namespace striate::python
