#include "striate/agent/replay/replay_mission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "striate/agent/landmark_knowledge.hpp"
#include "striate/agent/recording/decision.hpp"
#include "striate/agent/recording/setup.hpp"

namespace striate::agent {

ReplayMission::ReplayMission(const ReplayOptions& options) : reader_(options.recording) {
  const replay::RecordedSetup& then = reader_.setup();
  const RecordedFiles files(then);
  MissionOptions mission;
  mission.task = options.task.empty() ? files.task() : options.task;
  mission.robot = options.robot.empty() ? files.robot() : options.robot;
  mission.given = tasks::GivenVariables(then.variables.begin(), then.variables.end());
  mission.emergency_layer = then.emergency_layer;
  if (then.memory_known) mission.knowledge = read_mission_knowledge(files.memory());
  const BodySource recorded{.wake = [&](const RobotSettings&) -> Body {
                              auto robot = std::make_unique<replay::ReplayRobot>(reader_);
                              body_ = robot.get();
                              return {.robot = std::move(robot), .place = options.recording};
                            },
                            .description = then.robot};
  mission_.emplace(mission, recorded);
}

bool ReplayMission::step() {
  if (!body_->read_ahead()) return false;
  if (recorded().decision.interrupted) mission_->interrupt("ended from outside, as recorded");
  mission_->step();
  return true;
}

std::vector<std::string> ReplayMission::differences() const {
  replay::RecordedDecision now;
  note_decision(cycle().trace(), executive(), now);
  return agent::differences(now, recorded().decision);
}

std::vector<std::string> ReplayMission::changed_settings() const {
  const std::vector<replay::NamedText> now = printed_settings(settings());
  std::vector<std::string> changed;
  for (const auto& [key, value] : now) {
    if (key.starts_with("simulator.")) continue;  // the recording is the body
    const auto& then = reader_.setup().settings;
    const auto same_key =
        std::find_if(then.begin(), then.end(), [&](const auto& line) { return line.first == key; });
    if (same_key == then.end()) {
      changed.push_back(fmt::format("{} {} (then there was none)", key, value));
    } else if (same_key->second != value) {
      changed.push_back(fmt::format("{} {} (then {})", key, value, same_key->second));
    }
  }
  return changed;
}

}  // namespace striate::agent
