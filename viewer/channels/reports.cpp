#include "striate/viewer/channels/reports.hpp"

#include <fmt/format.h>

#include <cmath>

#include "striate/tasks/show/outline.hpp"
#include "striate/viewer/channels/ros_stamps.hpp"

namespace striate::viewer {
namespace {

// Levels of rcl_interfaces/Log
constexpr std::uint8_t kInfo = 20;
constexpr std::uint8_t kWarn = 30;
constexpr std::uint8_t kError = 40;

/// JSON has no infinity: what is not known is null.
Json known_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json command_json(const MotorCommand& command) {
  return {{"forward_m_s", command.forward_m_s},
          {"turn_rad_s", command.turn_rad_s},
          {"pan_rad", command.pan_rad},
          {"tilt_rad", command.tilt_rad}};
}

const char* name_of_progress(behaviours::Progress progress) {
  if (progress == behaviours::Progress::running) return "running";
  return progress == behaviours::Progress::succeeded ? "succeeded" : "failed";
}

/// The limiter's everyday work is no news.
bool is_held_back(behaviours::LimitReason reason) {
  return reason != behaviours::LimitReason::none && reason != behaviours::LimitReason::acceleration;
}

}  // namespace

const char* name_of(tasks::MissionState state) {
  switch (state) {
    case tasks::MissionState::succeeded:
      return "succeeded";
    case tasks::MissionState::failed:
      return "failed";
    case tasks::MissionState::interrupted:
      return "interrupted";
    case tasks::MissionState::running:
      break;
  }
  return "running";
}

Json task_tree(const tasks::Outline& outline) {
  Json children = Json::array();
  for (const tasks::Outline& child : outline.children) children.push_back(task_tree(child));
  return {{"title", tasks::title_of(outline)},
          {"limits", tasks::limits_of(outline)},
          {"line", outline.place.line},
          {"children", children}};
}

Json task_json(const CycleFacts& facts, const std::string& mission, const Json& tree) {
  return {{"mission", mission},
          {"state", name_of(facts.state)},
          {"reason", facts.reason},
          {"action", facts.doing},
          {"tree", tree}};
}

Json wish_json(const CycleFacts& facts) {
  const behaviours::Wish& wish = facts.wish;
  return {{"why", std::string(wish.why.view())},
          {"progress", name_of_progress(wish.progress)},
          {"driver", behaviours::name_of(facts.driver)},
          {"limited_by", behaviours::name_of(facts.limited_by)},
          {"wish", command_json({wish.forward_m_s, wish.turn_rad_s, wish.pan_rad, wish.tilt_rad})},
          {"sent", command_json(facts.sent)}};
}

Json memory_events_json(const CycleFacts& facts) {
  Json lessons = Json::array();
  for (const CycleFacts::Lesson& one : facts.lessons) {
    lessons.push_back({{"landmark", one.name}, {"kind", one.recognised ? "recognised" : "missed"}});
  }
  return {{"recognised", facts.recognised}, {"lessons", lessons}};
}

Json cycle_json(const CycleFacts& facts) {
  return {{"number", facts.number},
          {"time_s", to_seconds(facts.senses.now)},
          {"image_age_s", known_or_null(facts.image_age_s)},
          {"new_image", facts.new_image},
          {"refused", facts.refused},
          {"bumper", facts.senses.bumper},
          {"stalled", facts.senses.motors_stalled}};
}

msgs::DiagnosticArray diagnostics_of(const CycleFacts& facts) {
  const bool held = is_held_back(facts.limited_by) || !facts.refused.empty();
  msgs::DiagnosticStatus status;
  status.level = static_cast<std::byte>(held ? 1 : 0);  // WARN, OK
  status.name = "striate: mission";
  status.hardware_id = "striate";
  status.message = agent::doing_text(facts.wish.why, facts.limited_by);
  const auto add = [&status](const char* key, std::string value) {
    status.values.push_back({key, std::move(value)});
  };
  add("action", facts.doing);
  add("state", name_of(facts.state));
  add("limited by", behaviours::name_of(facts.limited_by));
  add("image refused", facts.refused);
  add("image age (s)", fmt::format("{:.3f}", facts.image_age_s));
  add("battery (V)", fmt::format("{:.1f}", facts.senses.battery_v));
  add("light level", fmt::format("{:.2f}", facts.slow.light_level));
  add("noise level", fmt::format("{:.1f}", facts.slow.noise_level));
  add("seen share", fmt::format("{:.2f}", facts.slow.seen_share));
  return {ros_header(facts.senses.now, ""), {status}};
}

std::vector<msgs::Log> LogTeller::news(const CycleFacts& facts) {
  std::vector<msgs::Log> list;
  const auto tell = [&](std::uint8_t level, const char* who, std::string text) {
    list.push_back({ros_time(facts.senses.now), level, who, std::move(text), "", "", 0});
  };
  if (facts.doing != doing_) {
    tell(kInfo, "task",
         facts.doing.empty() ? std::string("no action runs")
                             : fmt::format("{}: {}", facts.doing, facts.wish.why.view()));
  }
  if (is_held_back(facts.limited_by) && facts.limited_by != limited_by_) {
    tell(kWarn, "limiter", behaviours::name_of(facts.limited_by));
  }
  if (!facts.refused.empty() && facts.refused != refused_) tell(kWarn, "camera", facts.refused);
  if (facts.state != state_ && facts.state != tasks::MissionState::running) {
    const bool failed = facts.state == tasks::MissionState::failed;
    tell(failed ? kError : kInfo, "mission",
         fmt::format("{}: {}", name_of(facts.state), facts.reason));
  }
  doing_ = facts.doing;
  refused_ = facts.refused;
  limited_by_ = facts.limited_by;
  state_ = facts.state;
  return list;
}

}  // namespace striate::viewer
