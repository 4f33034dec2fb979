#include "striate/agent/replay/replay_mission.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "striate/agent/landmark_knowledge.hpp"
#include "striate/agent/plugins/load_plugin.hpp"
#include "striate/agent/recording/decision.hpp"
#include "striate/agent/recording/setup.hpp"
#include "striate/base/user_error.hpp"

namespace striate::agent {
namespace {

/// A recording is data: it says which plugins it needs, and you say where their code is.
void demand_plugins(const std::string& recording, const replay::RecordedSetup& setup) {
  for (const auto& [key, file] : setup.settings) {
    if (!key.starts_with(kRecordedPlugin)) continue;
    const std::string name = key.substr(std::string(kRecordedPlugin).size());
    const auto& used = plugins_in_use();
    const auto same = [&](const PluginInUse& plugin) { return plugin.name == name; };
    if (std::any_of(used.begin(), used.end(), same)) continue;
    throw UserError(
        fmt::format("{}: was recorded with the plugin '{}', which is not in use\n  hint: give it "
                    "with --plugin; then it was {}",
                    recording, name, file));
  }
}

}  // namespace

ReplayMission::ReplayMission(const ReplayOptions& options) : reader_(options.recording) {
  const replay::RecordedSetup& then = reader_.setup();
  demand_plugins(options.recording, then);
  const RecordedFiles files(then);
  MissionOptions mission;
  mission.task = options.task.empty() ? files.task() : options.task;
  mission.robot = options.robot.empty() ? files.robot() : options.robot;
  if (options.robot.empty()) mission.plugin_lines = PluginLines::ignore;
  mission.emergency_layer = then.emergency_layer;
  if (then.memory_known) mission.knowledge = read_mission_knowledge(files.memory());
  const BodySource recorded{
      .wake = [&](const RobotSettings&) -> Body {
        auto robot = std::make_unique<replay::ReplayRobot>(reader_);
        body_ = robot.get();
        return {.robot = std::move(robot), .place = options.recording};
      },
      // As a place gives them: not every task has them all.
      .given = tasks::GivenVariables(then.variables.begin(), then.variables.end()),
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
