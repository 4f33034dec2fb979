#pragma once

#include <memory>
#include <optional>
#include <string>

#include "striate/platform/interface/robot.hpp"
#include "striate/platform/pioneer/camera/stereo_camera.hpp"
#include "striate/platform/pioneer/driver_thread.hpp"
#include "striate/platform/pioneer/laser/laser_link.hpp"
#include "striate/platform/pioneer/pioneer_settings.hpp"
#include "striate/platform/pioneer/steady_clock.hpp"
#include "striate/platform/pioneer/turret/turret_link.hpp"

namespace striate::pioneer {

/// A Pioneer and its devices, as a body: base, turret, laser and stereo camera, each on a line and
/// in a thread of its own, all stamped by one steady clock. The base is a must; of the others those
/// that have a place. Laser and turret speak to the safety gate directly: a laser that falls silent
/// or a head that is stuck stops the wheels whatever the program does.
class PioneerRobot final : public Robot {
 public:
  /// Connects, switches the motors on, and waits until each device has spoken.
  /// @throws UserError for a wrong place, std::runtime_error when something does not come up.
  /// @param body its outline, and how fast it may drive at most; the rest it finds out
  explicit PioneerRobot(const PioneerSettings& settings, const RobotDescription& body = {},
                        Duration patience = std::chrono::seconds(15));
  /// The base alone. @param url see make_transport
  PioneerRobot(const BaseDriverSettings& settings, const std::string& url,
               Duration patience = std::chrono::seconds(15));

  [[nodiscard]] const RobotDescription& description() const override { return description_; }
  [[nodiscard]] const Clock& clock() const override { return clock_; }
  /// @throws std::runtime_error when the link broke; the robot stands then.
  bool sense(Senses& senses) override;
  void send(const MotorCommand& command) override;
  void stop() noexcept override;
  /// Ends what the safety gate has latched, and gives a tripped servo its torque back: somebody has
  /// looked at the robot.
  void reset();

  /// Why no image comes, or why the newest was refused; "": it is good, or there is no camera.
  [[nodiscard]] std::string camera_trouble() const;
  [[nodiscard]] DriverThread& driver() { return driver_; }
  /// Null: there is none.
  [[nodiscard]] TurretLink* turret() { return turret_.get(); }

 private:
  void connect_devices(const PioneerSettings& settings);
  void describe(const PioneerSettings& settings);
  void wait_for_all(const DevicePlaces& places, Duration patience);
  [[nodiscard]] std::string who_is_missing(const DevicePlaces& places) const;

  SteadyClock clock_;
  DriverThread driver_;
  // After the driver, so that they end before it: they speak to it.
  std::unique_ptr<TurretLink> turret_;
  std::unique_ptr<LaserLink> laser_;
  std::unique_ptr<StereoCamera> camera_;
  RobotDescription description_;
  TimePoint next_cycle_;
  std::optional<TimePoint> seen_at_;  ///< the newest image that was handed out
};

/// What a base tells, as senses: sonar seen from the axle, silent and stale discs left out.
void fill_senses(const BaseState& base, TimePoint now, Senses& senses);

}  // namespace striate::pioneer
