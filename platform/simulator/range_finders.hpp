#pragma once

#include <vector>

#include "striate/base/pioneer_devices.hpp"
#include "striate/platform/interface/robot.hpp"
#include "striate/platform/simulator/physics.hpp"
#include "striate/platform/simulator/random.hpp"
#include "striate/platform/simulator/simulator_settings.hpp"

namespace striate::simulator {

/// Where the discs sit and look, from the axle: as the robot says; else as on the Pioneer, and on a
/// body of another outline as near to its rim.
[[nodiscard]] std::vector<Pose2> sonar_mounts(const RobotDescription& robot);

/// The disc of each of so many arrays that fired last, for a scan that carries this stamp.
[[nodiscard]] std::vector<std::size_t> discs_fired_at(TimePoint stamp, std::size_t arrays);

/// Where the laser sits, from the axle.
[[nodiscard]] Pose2 laser_mount(const RobotDescription& robot);

inline constexpr std::size_t kDiscsOfAnArray = 8;

/// Arrays of eight discs. In each array one disc fires every 40 ms, so that a disc is 320 ms
/// old when its turn comes again. An echo comes from the nearest thing in the beam that throws
/// sound back: a smooth wall does so only where it stands nearly square to the beam.
class Sonar {
 public:
  Sonar(std::uint64_t seed, const SensorSettings& settings, const RobotDescription& robot = {});
  /// Fires the discs that are due by `now_s`.
  void step(double now_s, const Physics& physics);
  /// The newest echo of every disc, seen from the axle; stamped with the newest firing.
  [[nodiscard]] const RangeScan& scan() const { return scan_; }

 private:
  void fire(std::size_t disc, const Physics& physics);
  Random random_;
  SensorSettings settings_;
  std::vector<Pose2> mounts_;
  RangeScan scan_;
  std::uint64_t fired_ = 0;
};

/// A laser scanner at the Pioneer's usual place: 181 rays over the front half circle.
class Laser {
 public:
  Laser(std::uint64_t seed, const SensorSettings& settings, const RobotDescription& robot = {})
      : random_(seed, Purpose::laser), settings_(settings), mount_(laser_mount(robot)) {}
  /// A whole sweep at this moment.
  [[nodiscard]] RangeScan sweep(TimePoint now, const Physics& physics);
  /// One ray from the laser itself, counter-clockwise from ahead; +inf beyond its range.
  [[nodiscard]] double range_m(double bearing_rad, const Physics& physics);

 private:
  Random random_;
  SensorSettings settings_;
  Pose2 mount_;
  std::uint64_t rays_ = 0;
};

}  // namespace striate::simulator
