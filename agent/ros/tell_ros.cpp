#include "striate/agent/ros/tell_ros.hpp"

#include <fmt/format.h>

#include <memory>
#include <string>

namespace striate::agent {
namespace {

/// Diagnostics are published at 1 Hz by habit of ROS
constexpr Duration kHealthEvery = std::chrono::seconds(1);
constexpr double kOldImage_s = 0.5;  // five images missed, as RosSettings::stale_s

}  // namespace

TellRos::TellRos(const Mission& mission, ros::Tells tells)
    : publisher_(mission.settings().ros, mission.body().description(), tells) {}

void TellRos::tell(const Mission& mission) {
  const CycleTrace& trace = mission.cycle().trace();
  publisher_.publish(trace.senses);
  const perception::DisparityMap& map = trace.percept.disparity;
  if (!map.disparity_px.empty() && trace.percept.stamp != disparity_stamp_) {
    disparity_stamp_ = trace.percept.stamp;
    publisher_.publish({map.disparity_px, map.focal_px, map.baseline_m,
                        static_cast<double>(map.disparity_px.cols)},
                       trace.percept.stamp);
  }
  if (health_told_ == TimePoint(Duration::min()) ||
      trace.senses.now - health_told_ >= kHealthEvery) {
    health_told_ = trace.senses.now;
    publisher_.publish(health_of(mission));
  }
}

ros::Health TellRos::health_of(const Mission& mission) {
  const CycleTrace& trace = mission.cycle().trace();
  const double image_age_s = to_seconds(trace.senses.now - trace.senses.stereo.stamp);
  const std::string hold = mission.hold();
  ros::Health health;
  health.ok = hold.empty() && image_age_s < kOldImage_s && !trace.senses.motors_stalled &&
              !trace.senses.bumper;
  health.summary = fmt::format("{}: {}", mission.executive().current_action(),
                               std::string(trace.wish.why.view()));
  health.details = {
      {"motors", name_of(trace.driver)},
      {"limited by", name_of(trace.limited_by)},
      {"gate", hold},
      {"image age s", fmt::format("{:.3f}", image_age_s)},
      {"battery V", fmt::format("{:.1f}", trace.senses.battery_v)},
      {"bumper", trace.senses.bumper ? "touched" : "free"},
      {"motors stalled", trace.senses.motors_stalled ? "yes" : "no"},
      {"cycle ms", fmt::format("{:.1f}", mission.mean_cycle_ms())},
      {"emergency stops", fmt::format("{}", mission.cycle().limiter().emergency_stops())},
  };
  return health;
}

CognitiveCycle::Pilot cmd_vel_pilot(const ros::RosSettings& settings, double resting_tilt_rad) {
  const auto pilot = std::make_shared<ros::CmdVelPilot>(settings, HeadPose{0.0, resting_tilt_rad});
  return [pilot](TimePoint now) -> std::optional<behaviours::Wish> {
    const std::optional<MotorCommand> command = pilot->wanted();
    if (!command) return std::nullopt;
    behaviours::Wish wish;
    wish.forward_m_s = command->forward_m_s;
    wish.turn_rad_s = command->turn_rad_s;
    wish.pan_rad = command->pan_rad;
    wish.tilt_rad = command->tilt_rad;
    wish.why = "cmd_vel drives";
    wish.stamp = now;
    return wish;
  };
}

}  // namespace striate::agent
