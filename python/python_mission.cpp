#include "striate/python/python_mission.hpp"

#include <fmt/format.h>

#include <thread>

#include "striate/agent/landmark_knowledge.hpp"
#include "striate/agent/mission.hpp"
#include "striate/agent/mission_memory.hpp"
#include "striate/agent/plugins/plugin_body.hpp"
#include "striate/agent/recording/mission_recorder.hpp"
#include "striate/agent/simulated_body.hpp"
#include "striate/app/pace.hpp"
#include "striate/app/reports.hpp"
#include "striate/base/files.hpp"
#include "striate/base/files_apart.hpp"
#include "striate/base/user_error.hpp"
#include "striate/python/failures.hpp"
#include "striate/python/files.hpp"
#include "striate/python/running_missions.hpp"
#include "striate/python/shown_cycle.hpp"
#include "striate/python/truth.hpp"
#include "striate/python/wishes.hpp"

namespace striate::python {
namespace {

constexpr const char* kKeptRecording = "the recording";
constexpr const char* kKeptMemory = "the long-term memory";
constexpr const char* kKeptResult = "the result";

agent::BodySource body_for(const MissionRequest& request) {
  if (request.world.empty()) return agent::named_body(robot_file(request.robot));
  agent::WorldOptions world;
  world.world = world_file(request.world);
  world.seed = request.seed;
  world.baseline = request.baseline;
  world.start = request.start;
  return agent::simulated_pioneer(world);
}

agent::MissionOptions options_for(const MissionRequest& request) {
  agent::MissionOptions options;
  options.task = task_file(request.task);
  options.robot = robot_file(request.robot);
  if (!options.robot.empty()) open_to_plugins();
  options.given = request.variables;
  options.emergency_layer = request.emergency;
  if (!request.memory.empty()) options.knowledge = agent::read_mission_knowledge(request.memory);
  return options;
}

/// Python's own code, called by the mission in its thread.
class PythonOnlooker {
 public:
  explicit PythonOnlooker(const MissionRequest& request)
      : request_(request), looks_on_(!request.each_cycle.is_none()) {}

  /// Until the callback asks for the end: the task's `finally` drives then.
  void take_the_wheel(agent::Mission& mission) const {
    if (request_.pilot.is_none()) return;
    mission.set_pilot([this, &mission](TimePoint) {
      return ends_ ? std::optional<behaviours::Wish>() : wish_of_pilot(mission);
    });
  }

  /// @return whether the mission is to end @throws std::runtime_error where the interpreter ends
  [[nodiscard]] bool look(const agent::Mission& mission) {
    running_missions().check();  // before the lock, which an interpreter that ends does not give
    if (!looks_on_ && !request_.hears_signals) return false;
    return in_python("the callback", [&] {
      if (request_.hears_signals && PyErr_CheckSignals() != 0) throw py::error_already_set();
      const bool asked = looks_on_ && asks_for_the_end(mission);
      ends_ = ends_ || asked;
      return asked;
    });
  }

 private:
  /// What is false to Python, a numpy.bool_ too, but not None: most callbacks return nothing.
  [[nodiscard]] bool asks_for_the_end(const agent::Mission& mission) const {
    const auto cycle = std::make_shared<ShownCycle>(mission);
    struct End {
      ShownCycle& cycle;
      ~End() { cycle.end(); }
    } const end{*cycle};
    const py::object answer = request_.each_cycle(cycle);
    return !answer.is_none() && !is_true(answer);
  }

  [[nodiscard]] std::optional<behaviours::Wish> wish_of_pilot(const agent::Mission& mission) const {
    return in_python("the pilot", [&]() -> std::optional<behaviours::Wish> {
      const memory::ShortTermMemory& memory = mission.cycle().memory();
      const MemoryLoan loan(memory);
      const py::object wished = request_.pilot(loan.lent());
      if (wished.is_none()) return {};
      try {
        return wish_of(returned_wish(wished, "the pilot"), memory);
      } catch (const UserError& error) {
        throw py::value_error(error.what());
      }
    });
  }

  const MissionRequest& request_;
  bool looks_on_;
  bool ends_ = false;
};

/// What is written down of a mission: never a reason for it to end.
class PythonKeepers {
 public:
  PythonKeepers(const MissionRequest& request, agent::MissionRecorder& recorder,
                agent::Mission& mission)
      : recorder_(recorder),
        memory_(request.memory, mission, task_file(request.task)),
        mission_(mission) {
    recorder_.begin(mission);
  }
  void take() noexcept {
    reports_.attempt(kKeptRecording, [this] { recorder_.take(mission_); });
    reports_.attempt(kKeptMemory, [this] { memory_.take(mission_); });
  }
  void finish(const MissionRequest& request, MissionOutcome& outcome) noexcept {
    reports_.finish(kKeptResult, [&] {
      outcome.json = agent::to_json(outcome.result).dump(2) + "\n";
      if (!request.result.empty()) write_file(request.result, outcome.json);
    });
    reports_.finish(kKeptRecording, [&] {
      const agent::RecordingEnd end = recorder_.finish();
      reports_.note(kKeptRecording, end.lost.c_str());
    });
    reports_.finish(kKeptMemory, [&] {
      reports_.note(kKeptMemory, memory_.finish(mission_, outcome.result).c_str());
    });
    outcome.losses = reports_.text();
  }

 private:
  agent::MissionRecorder& recorder_;
  agent::MissionMemory memory_;
  agent::Mission& mission_;
  app::Reports reports_;
};

void check_outputs(const MissionRequest& request, const agent::MissionOptions& options) {
  check_apart(
      {{"memory", request.memory}, {"record", request.record}, {"result", request.result}},
      {{"task", options.task}, {"robot", options.robot}, {"world", world_file(request.world)}});
  for (const std::string& file : {request.result, request.record, request.memory}) {
    check_writable(file);
  }
}

MissionOutcome run_unlocked(const MissionRequest& request) {
  const agent::MissionOptions options = options_for(request);
  check_outputs(request, options);
  agent::MissionRecorder recorder(request.record, request.memory);  // copies it as it is now
  agent::Mission mission(options, body_for(request));
  MissionOutcome outcome;
  outcome.notices = mission.notices();
  PythonKeepers keepers(request, recorder, mission);
  PythonOnlooker onlooker(request);
  onlooker.take_the_wheel(mission);
  app::Pace pace(request.real_time ? 1.0 : 0.0);
  outcome.result = mission.run([&](const agent::Mission& now) {
    keepers.take();
    std::this_thread::sleep_until(
        pace.due(now.cycle().trace().senses.now, app::Pace::Steady::now()));
    return onlooker.look(now);
  });
  keepers.finish(request, outcome);
  return outcome;
}

}  // namespace

MissionOutcome run_mission(const MissionRequest& request) {
  forget_failure();
  const RunningMission counted;  // until the interpreter's lock is held again
  MissionOutcome outcome;
  {
    const py::gil_scoped_release unlocked;
    outcome = run_unlocked(request);
  }
  raise_failure();
  return outcome;
}

}  // namespace striate::python
