#include "striate/platform/pioneer/pioneer_robot.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "striate/platform/interface/seen_from_axle.hpp"
#include "striate/platform/pioneer/camera/make_stereo_camera.hpp"

namespace striate::pioneer {
namespace {

/// Between looks while the base is awaited: below a fifth of a SIP cycle
constexpr Duration kLookAgain = std::chrono::milliseconds(20);

}  // namespace

void fill_senses(const BaseState& base, TimePoint now, Senses& senses) {
  senses.now = now;
  senses.odometry = base.odometry;
  senses.sonar.readings.clear();
  senses.sonar.stamp = {};
  for (std::size_t disc = 0; disc < base.discs.size(); ++disc) {
    const DiscReading& reading = base.sonar[disc];
    if (!reading.told || now - reading.stamp > kSonarFresh) continue;
    senses.sonar.readings.push_back(seen_from_axle(base.discs[disc], reading.range_m));
    senses.sonar.stamp = std::max(senses.sonar.stamp, reading.stamp);
  }
  senses.laser = base.laser;
  senses.battery_v = base.battery_v;
  senses.bumper = base.bumper_front || base.bumper_rear;
  senses.motors_stalled = base.stalled_left || base.stalled_right;
}

namespace {

PioneerSettings base_alone(const BaseDriverSettings& settings, const std::string& url) {
  PioneerSettings all;
  all.base = settings;
  all.devices.base = url;
  return all;
}

}  // namespace

PioneerRobot::PioneerRobot(const BaseDriverSettings& settings, const std::string& url,
                           Duration patience)
    : PioneerRobot(base_alone(settings, url), {}, patience) {}

PioneerRobot::PioneerRobot(const PioneerSettings& settings, const RobotDescription& body,
                           Duration patience)
    : driver_(settings.base, make_kept_transport(settings.devices.base), clock_),
      description_(body) {
  connect_devices(settings);
  wait_for_all(settings.devices, patience);
  describe(settings);
  next_cycle_ = clock_.now();
}

/// What was told of the body, as far as base, head and camera allow it.
void PioneerRobot::describe(const PioneerSettings& settings) {
  const auto at_most = [](double& limit, double other) { limit = std::min(limit, other); };
  const DriverReport report = driver_.report();
  at_most(description_.max_forward_m_s, report.most_forward_m_s);
  at_most(description_.max_turn_rad_s, report.most_turn_rad_s);
  at_most(description_.max_acceleration_m_s2, settings.base.session.acceleration_m_s2);
  at_most(description_.max_turn_acceleration_rad_s2,
          settings.base.session.turn_acceleration_rad_s2);
  description_.camera_height_m = settings.camera.height_m;
  description_.camera_forward_m = settings.camera.forward_m;
  description_.resting_tilt_rad = settings.camera.resting_tilt_rad;
  description_.view_rad = settings.camera.field_rad;
  if (camera_) {
    const StereoFrame frame = camera_->newest();
    if (frame.focal_px > 0.0) {
      description_.view_rad = 2.0 * std::atan(0.5 * frame.left.cols / frame.focal_px);
    }
  }
  if (turret_) {
    at_most(description_.max_pan_rad, settings.turret.most_pan_rad);
    at_most(description_.max_tilt_rad, settings.turret.most_tilt_rad);
  }
}

void PioneerRobot::connect_devices(const PioneerSettings& settings) {
  const DevicePlaces& places = settings.devices;
  if (!places.turret.empty()) {
    turret_ = std::make_unique<TurretLink>(settings.turret, make_transport(places.turret), clock_,
                                           [this](bool ok) { driver_.set_head_ok(ok); });
  }
  if (!places.laser.empty()) {
    laser_ = std::make_unique<LaserLink>(settings.laser, make_transport(places.laser), clock_,
                                         [this](TimePoint at) { driver_.laser_has_measured(at); });
  }
  if (!places.camera.empty()) {
    camera_ = make_stereo_camera(places.camera, settings.camera, clock_);
  }
}

std::string PioneerRobot::who_is_missing(const DevicePlaces& places) const {
  const auto say = [](const std::string& place, const std::string& trouble, const char* otherwise) {
    return place + ": " + (trouble.empty() ? otherwise : trouble);
  };
  const DriverReport report = driver_.report();
  if (report.state != LinkState::ready || !report.base.motors_on) {
    return say(places.base, report.trouble, "the robot's motors do not come on");
  }
  if (turret_ && !turret_->report().known()) {
    return say(places.turret, turret_->trouble(), "the turret's servos do not answer");
  }
  if (laser_ && laser_->scan().readings.empty()) {
    return say(places.laser, laser_->trouble(), "the laser does not measure");
  }
  if (camera_ && camera_->newest().left.empty()) {
    return say(places.camera, camera_->trouble(), "the camera sends no image");
  }
  return {};
}

void PioneerRobot::wait_for_all(const DevicePlaces& places, Duration patience) {
  const TimePoint end = clock_.now() + patience;
  (void)driver_.wait_until_it_can_drive(patience);
  std::string missing = who_is_missing(places);
  while (!missing.empty() && clock_.now() < end && driver_.report().state != LinkState::refused) {
    std::this_thread::sleep_for(kLookAgain);
    missing = who_is_missing(places);
  }
  if (!missing.empty()) throw std::runtime_error(missing);
}

bool PioneerRobot::sense(Senses& senses) {
  next_cycle_ = std::max(next_cycle_ + description_.cycle, clock_.now());
  std::this_thread::sleep_for(next_cycle_ - clock_.now());
  const DriverReport report = driver_.report();
  fill_senses(report.base, clock_.now(), senses);
  if (laser_) senses.laser = laser_->scan();
  if (camera_) {
    senses.stereo = camera_->newest();
    seen_at_ = senses.stereo.stamp;
  }
  if (turret_) {
    const HeadReport head = turret_->report();
    senses.head = head.pose;
    senses.stereo.head = head.trajectory.at(senses.stereo.stamp);
  }
  // Not by the reason alone: a higher one may hide that the link is gone.
  if (report.state != LinkState::ready || report.hold == HoldReason::link_lost) {
    throw std::runtime_error("the robot is lost: " + report.trouble);
  }
  return true;
}

std::string PioneerRobot::camera_trouble() const {
  return camera_ ? camera_->trouble() : std::string();
}

void PioneerRobot::send(const MotorCommand& command) {
  driver_.command(command, seen_at_);
  if (turret_) turret_->command({command.pan_rad, command.tilt_rad});
}

void PioneerRobot::reset() {
  driver_.reset();
  if (turret_) turret_->reset();
}

void PioneerRobot::stop() noexcept {
  try {
    driver_.command({});
  } catch (...) {  // a lock that fails: the lease ends by itself
  }
}

}  // namespace striate::pioneer
