#pragma once

#include <algorithm>
#include <chrono>
#include <memory>
#include <thread>

#include "striate/platform/interface/robot.hpp"

namespace striate::agent {

/// Holds a simulated body back to real time, because those who listen live in it. What it cannot
/// keep up with is not caught up.
class RealTimeRobot final : public Robot {
 public:
  explicit RealTimeRobot(std::unique_ptr<Robot> body) : body_(std::move(body)) {}
  [[nodiscard]] const RobotDescription& description() const override {
    return body_->description();
  }
  [[nodiscard]] const Clock& clock() const override { return body_->clock(); }
  bool sense(Senses& senses) override {
    std::this_thread::sleep_until(next_);
    next_ = std::max(next_ + description().cycle, Steady::now());
    return body_->sense(senses);
  }
  void send(const MotorCommand& command) override { body_->send(command); }
  void stop() noexcept override { body_->stop(); }

 private:
  using Steady = std::chrono::steady_clock;
  std::unique_ptr<Robot> body_;
  Steady::time_point next_ = Steady::now();
};

}  // namespace striate::agent
