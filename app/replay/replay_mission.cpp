#include "app/replay/replay_mission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "app/memory/landmark_knowledge.hpp"
#include "app/recording/decision.hpp"
#include "tasks/task_reader.hpp"

namespace striate {

ReplayMission::ReplayMission(const ReplayOptions& options)
    : reader_(options.recording), body_(reader_) {
  const replay::RecordedSetup& then = reader_.setup();
  const RecordedFiles files(then);
  settings_ = load_robot_settings(options.robot.empty() ? files.robot() : options.robot);
  settings_.safety.emergency_layer = settings_.safety.emergency_layer && then.emergency_layer;
  const GivenVariables given(then.variables.begin(), then.variables.end());
  std::optional<MissionKnowledge> knowledge;
  if (then.memory_known) knowledge = read_mission_knowledge(files.memory());
  const std::vector<std::string> names =
      knowledge ? knowledge->names() : std::vector<std::string>();
  executive_ = std::make_unique<Executive>(
      load_task(options.task.empty() ? files.task() : options.task, body_.description(), given,
                then.memory_known ? &names : nullptr));
  cycle_ = std::make_unique<CognitiveCycle>(body_, settings_, *executive_);
  if (!knowledge) return;
  hand_over(std::move(*knowledge), executive_->task(), settings_.long_term_memory, *cycle_);
}

bool ReplayMission::step() {
  if (!body_.read_ahead()) return false;
  if (body_.cycle().decision.interrupted) {
    executive_->interrupt(MissionState::interrupted, "ended from outside, as recorded");
  }
  cycle_->step();
  trail_.add(cycle_->trace().senses.odometry.pose);
  return true;
}

std::vector<std::string> ReplayMission::differences() const {
  replay::RecordedDecision now;
  note_decision(cycle_->trace(), *executive_, now);
  return striate::differences(now, recorded().decision);
}

std::vector<std::string> ReplayMission::changed_settings() const {
  const std::vector<replay::NamedText> now = printed_settings(settings_);
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

}  // namespace striate
