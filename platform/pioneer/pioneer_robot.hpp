#pragma once

#include <memory>
#include <string>

#include "platform/interface/robot.hpp"
#include "platform/pioneer/driver_thread.hpp"
#include "platform/pioneer/steady_clock.hpp"

namespace striate::pioneer {

/// A Pioneer at the other end of a line, as a body: wheels, odometry, sonar, bumpers, battery. It
/// has no camera and no head; pictures stay empty and the head at rest.
class PioneerRobot final : public Robot {
 public:
  /// Connects and switches the motors on.
  /// @param url see make_transport
  /// @throws UserError for a wrong url, std::runtime_error when the robot does not come up.
  PioneerRobot(const BaseDriverSettings& settings, const std::string& url,
               Duration patience = std::chrono::seconds(15));

  [[nodiscard]] const RobotDescription& description() const override { return description_; }
  [[nodiscard]] const Clock& clock() const override { return clock_; }
  /// @throws std::runtime_error when the link broke; the robot stands then.
  bool sense(Senses& senses) override;
  void send(const MotorCommand& command) override { driver_.command(command); }
  void stop() noexcept override;

  [[nodiscard]] DriverThread& driver() { return driver_; }

 private:
  SteadyClock clock_;
  DriverThread driver_;
  RobotDescription description_;
  TimePoint next_cycle_;
};

/// What a base tells, as senses: sonar seen from the axle, silent and stale discs left out.
void fill_senses(const BaseState& base, TimePoint now, Senses& senses);

}  // namespace striate::pioneer
