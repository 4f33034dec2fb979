#include "striate/app/commands/run_mission.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "striate/agent/given_variables.hpp"
#include "striate/agent/landmark_knowledge.hpp"
#include "striate/agent/mission_memory.hpp"
#include "striate/agent/mission_pictures.hpp"
#include "striate/agent/recall/live_memory.hpp"
#include "striate/agent/recording/mission_recorder.hpp"
#include "striate/agent/simulated_body.hpp"
#include "striate/app/commands/run_report.hpp"
#include "striate/app/interrupt.hpp"
#include "striate/app/operator_reset.hpp"
#include "striate/app/status_line.hpp"
#include "striate/base/files.hpp"

namespace striate::app {
namespace {

agent::MissionOptions mission_options(const RunOptions& options) {
  agent::MissionOptions mission = options.mission;
  mission.given = agent::read_variables(options.given);
  mission.emergency_layer = !options.no_emergency;
  if (!options.memory.empty()) mission.knowledge = agent::read_mission_knowledge(options.memory);
  return mission;
}

/// For the long-term memory: which session that was.
std::string session_title(const agent::Mission& mission, const agent::MissionOptions& asked) {
  if (mission.simulated() == nullptr) return fmt::format("{} with {}", asked.task, asked.robot);
  return fmt::format("{} in {}, seed {}", asked.task, mission.place(),
                     mission.simulated()->options().seed);
}

/// All who watch a mission from outside.
class Watchers {
 public:
  Watchers(const RunOptions& options, agent::Mission& mission, agent::MissionRecorder& recorder)
      : options_(options),
        mission_(mission),
        recorder_(recorder),
        pictures_(options.pictures, options.picture_every),
        memory_(options.memory, options.mission.robot, session_title(mission, options.mission)),
        live_(options.inspect),
        status_(options.quiet || options.json) {
    recorder_.begin(mission);
  }

  /// After each cycle, before anything ends the task from outside.
  void take() {
    recorder_.take(mission_);
    live_.take(mission_.cycle(), mission_.executive(), mission_.cycles());
    pictures_.take(mission_);
    if (const std::string said = speech_.news(mission_); !said.empty()) status_.tell(said);
    memory_.take(mission_.cycle());
    if (mission_.judge() != nullptr) memory_.take(*mission_.judge());
    if (options_.each_cycle) options_.each_cycle(mission_);
    let_go_on();
    if (status_.due()) status_.show(status_text(mission_));
  }

  /// A robot that holds until it is reset waits for a person, who is told once.
  void let_go_on() {
    const bool asked = reset_.asked();
    const bool waits = mission_.waits_for_reset();
    if (waits && !told_to_wait_) {
      status_.tell(fmt::format("the robot stands until you let it go on ({}): {}", mission_.hold(),
                               OperatorReset::hint()));
    }
    told_to_wait_ = waits;
    if (!waits || !asked) return;
    mission_.reset_body();
    status_.tell("the robot goes on");
  }

  /// @return what was recorded, for the summary; "" without a recording
  std::string finish(const agent::RunResult& result) {
    status_.clear();
    const std::string recorded = recorder_.finish();
    live_.finish();
    memory_.finish(mission_.cycle(), result);
    pictures_.finish(mission_, result);
    return recorded;
  }

 private:
  const RunOptions& options_;
  agent::Mission& mission_;
  agent::MissionRecorder& recorder_;
  agent::MissionPictures pictures_;
  agent::MissionMemory memory_;
  agent::LiveMemory live_;
  StatusLine status_;
  Speech speech_;
  OperatorReset reset_;
  bool told_to_wait_ = false;
};

}  // namespace

void check_outputs(const RunOptions& options) {
  for (const std::string& file :
       {options.result, options.record, options.inspect, options.memory}) {
    check_writable(file);
  }
  make_folder(options.pictures);
}

int run_mission(const RunOptions& options, const agent::BodySource& body) {
  check_outputs(options);
  const agent::MissionOptions asked = mission_options(options);
  const Interrupt interrupt;
  agent::MissionRecorder recorder(options.record,
                                  options.memory);  // copies the memory as it is now
  agent::Mission mission(asked, body);
  if (!options.quiet) fmt::print(stderr, "{}", mission.notices());
  Watchers watchers(options, mission, recorder);
  if (options.at_begin) options.at_begin(mission);
  const agent::RunResult result = mission.run([&](const agent::Mission&) {
    watchers.take();
    return Interrupt::requested();
  });
  const std::string recorded = watchers.finish(result);
  const std::string json = agent::to_json(result).dump(2) + "\n";
  if (!options.result.empty()) write_file(options.result, json);
  if (options.json) {
    fmt::print("{}", json);
  } else if (!options.quiet) {
    print_summary(result);
    if (!options.result.empty()) fmt::print("  record            {}\n", options.result);
    if (!options.pictures.empty()) fmt::print("  images          {}\n", options.pictures);
    if (!recorded.empty()) fmt::print("  recording         {}\n", recorded);
  }
  return agent::row_of(result.outcome).exit_code;
}

}  // namespace striate::app
