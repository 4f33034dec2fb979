#include "striate/app/recorded_odometry.hpp"

#include <cmath>

#include "striate/base/user_error.hpp"
#include "striate/platform/replay/recording_reader.hpp"

namespace striate::app {

datasets::Trajectory recorded_odometry(const std::string& recording) {
  replay::RecordingReader reader(recording);
  datasets::Trajectory trajectory;
  trajectory.format = "recording";
  replay::RecordedCycle cycle;
  while (reader.next(cycle)) {
    const Odometry& felt = cycle.senses.odometry;
    datasets::TimedPose pose;
    pose.stamp_ns = felt.stamp.time_since_epoch().count();
    if (!trajectory.poses.empty() && pose.stamp_ns <= trajectory.poses.back().stamp_ns) continue;
    const double c = std::cos(felt.pose.heading_rad);
    const double s = std::sin(felt.pose.heading_rad);
    pose.rotation = {c, -s, 0, s, c, 0, 0, 0, 1};
    pose.position_m = {felt.pose.x_m, felt.pose.y_m, 0.0};
    trajectory.poses.push_back(pose);
  }
  if (trajectory.poses.empty()) throw UserError(recording + ": holds no cycle with odometry");
  return trajectory;
}

datasets::Trajectory read_estimate(const std::string& file, const std::string& times) {
  if (replay::is_recording(file)) return recorded_odometry(file);
  return datasets::read_trajectory(file, times);
}

}  // namespace striate::app
