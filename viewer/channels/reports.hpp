#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "striate/tasks/task.hpp"
#include "striate/viewer/channels/cycle_facts.hpp"
#include "striate/viewer/messages/report_messages.hpp"

/// What the robot says of itself: JSON for what only Striate has, log and diagnostics of ROS 2.
namespace striate::viewer {

using Json = nlohmann::ordered_json;

/// The tree of a task: title, limits and line of each node, and its children.
[[nodiscard]] Json task_tree(const tasks::Outline& outline);
[[nodiscard]] Json task_json(const CycleFacts& facts, const std::string& mission, const Json& tree);
[[nodiscard]] Json wish_json(const CycleFacts& facts);
[[nodiscard]] Json memory_events_json(const CycleFacts& facts);
[[nodiscard]] Json cycle_json(const CycleFacts& facts);

/// Once a second: warns where the mission is held back.
[[nodiscard]] msgs::DiagnosticArray diagnostics_of(const CycleFacts& facts);

/// Tells what has changed since the cycle before: the action, what limits it, a refused image, how
/// the mission ended.
class LogTeller {
 public:
  [[nodiscard]] std::vector<msgs::Log> news(const CycleFacts& facts);

 private:
  std::string doing_;
  std::string refused_;
  behaviours::LimitReason limited_by_ = behaviours::LimitReason::none;
  tasks::MissionState state_ = tasks::MissionState::running;
};

[[nodiscard]] const char* name_of(tasks::MissionState state);

}  // namespace striate::viewer
