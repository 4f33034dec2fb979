#pragma once

#include <chrono>

#include "striate/platform/interface/robot.hpp"

namespace striate::agent {

/// Passes everything on to a body and adds up the wall-clock time that its `sense` took, so that
/// the time of the mind can be told from that of the simulation. Nothing decides by it.
class StopwatchRobot final : public Robot {
 public:
  explicit StopwatchRobot(Robot& body) : body_(body) {}
  [[nodiscard]] const RobotDescription& description() const override { return body_.description(); }
  [[nodiscard]] const Clock& clock() const override { return body_.clock(); }
  bool sense(Senses& senses) override {
    const auto begin = std::chrono::steady_clock::now();
    const bool goes_on = body_.sense(senses);
    sense_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return goes_on;
  }
  void send(const MotorCommand& command) override { body_.send(command); }
  void stop() noexcept override { body_.stop(); }
  [[nodiscard]] double sense_s() const { return sense_s_; }

 private:
  Robot& body_;
  double sense_s_ = 0.0;
};

}  // namespace striate::agent
