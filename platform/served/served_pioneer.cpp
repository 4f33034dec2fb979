#include "striate/platform/served/served_pioneer.hpp"

#include <algorithm>
#include <cmath>

namespace striate::served {
namespace {

/// The servos' models set the pace; the simulated head keeps up with them.
constexpr double kHeadFollows_rad_s = 20.0;
constexpr Duration kLaserPeriod = std::chrono::milliseconds(100);  // both lasers sweep at 10 Hz

/// The controller ramps speeds itself: the motors below it follow as fast as motors do.
RobotDescription with_motors(RobotDescription robot) {
  robot.max_forward_m_s = 1.0;
  robot.max_turn_rad_s = radians(360.0);
  robot.max_acceleration_m_s2 = 2.5;
  robot.max_turn_acceleration_rad_s2 = 12.0;
  robot.cycle = ServedPioneer::kStep;
  return robot;
}

/// With the sonar of the kind that it is served as, whose places its clients know.
RobotDescription with_sonar_of(const std::string& kind, RobotDescription robot) {
  const pioneer::RobotModel* model = pioneer::find_model(kind);
  if (model != nullptr && model->discs.data() != sonar_discs().data()) {
    robot.sonar_discs.assign(model->discs.begin(), model->discs.end());
  }
  return robot;
}

simulator::SimulatorSettings for_serving(simulator::SimulatorSettings settings) {
  settings.base.command_latency_s = 0.0;  // the line has its own
  settings.sensors.servo_speed_rad_s = kHeadFollows_rad_s;
  settings.judge = {.ends_at_collision = false, .ends_at_goal = false, .time_limit_s = 0.0};
  return settings;
}

double range_from(const Pose2& sensor, const RangeReading& seen) {
  if (!std::isfinite(seen.distance_m)) return seen.distance_m;
  return std::hypot(seen.distance_m * std::cos(seen.bearing_rad) - sensor.x_m,
                    seen.distance_m * std::sin(seen.bearing_rad) - sensor.y_m);
}

}  // namespace

ServedPioneer::ServedPioneer(const simulator::World& world, std::uint64_t seed,
                             const simulator::SimulatorSettings& settings,
                             const ServedDevices& devices, const RobotDescription& robot)
    : sonar_mounts_(simulator::sonar_mounts(with_sonar_of(devices.base.subclass, robot))),
      body_(world, seed, for_serving(settings), nullptr,
            with_sonar_of(devices.base.subclass, with_motors(robot))),
      firmware_(devices.base),
      servos_({pioneer::ServoModel(1, 0.0), pioneer::ServoModel(2, 0.0)}),
      laser_(devices.laser),
      camera_(seed, settings.sensors, settings.faults),
      laser_range_m_(settings.sensors.laser_range_m) {}

void ServedPioneer::hand_over_sonar() {
  if (senses_.sonar.stamp == sonar_stamp_) return;
  sonar_stamp_ = senses_.sonar.stamp;
  const std::size_t arrays = sonar_mounts_.size() / simulator::kDiscsOfAnArray;
  for (const std::size_t disc : simulator::discs_fired_at(sonar_stamp_, arrays)) {
    firmware_.sonar(disc, range_from(sonar_mounts_[disc], senses_.sonar.readings[disc]));
  }
}

void ServedPioneer::hand_over_laser() {
  if (!firmware_.laser_wanted() || now() < next_laser_) return;
  next_laser_ = now() + kLaserPeriod;
  std::vector<std::uint16_t> ranges_mm;
  for (const double bearing_rad : firmware_.laser_bearings_rad()) {
    const double range_m = std::min(body_.laser_range_m(bearing_rad), laser_range_m_);
    ranges_mm.push_back(static_cast<std::uint16_t>(std::lround(1000.0 * range_m)));
  }
  firmware_.laser(ranges_mm);
}

void ServedPioneer::step() {
  servos_.step(kStep);
  body_.send({.forward_m_s = firmware_.forward_m_s(),
              .turn_rad_s = firmware_.turn_rad_s(),
              .pan_rad = servos_.servos[0].angle_rad(),
              .tilt_rad = servos_.servos[1].angle_rad()});
  if (const auto place = firmware_.take_new_place()) body_.put_at(*place);
  body_.sense(senses_);
  hand_over_sonar();
  hand_over_laser();
  laser_.step(now(), [this](double bearing_rad) { return body_.laser_range_m(bearing_rad); });
  pioneer::FirmwareSenses felt;
  felt.odometry = senses_.odometry;
  felt.battery_v = senses_.battery_v;
  felt.stalled = senses_.motors_stalled;
  // The bumper rings touch on the side that the robot drives to.
  felt.bumper_front = senses_.bumper && firmware_.forward_m_s() >= 0.0;
  felt.bumper_rear = senses_.bumper && firmware_.forward_m_s() < 0.0;
  const simulator::SceneState truth = body_.scene();
  felt.true_pose = truth.robot;
  felt.true_turn_rad_s = truth.turn_rad_s;
  firmware_.step(now(), kStep, felt);
}

}  // namespace striate::served
