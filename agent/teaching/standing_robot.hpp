#pragma once

#include <cstdint>
#include <memory>

#include "striate/agent/robot_settings.hpp"
#include "striate/platform/interface/robot.hpp"
#include "striate/platform/simulator/render/renderer.hpp"
#include "striate/platform/simulator/scene.hpp"

namespace striate::agent {

/// A body that stands where it is put and looks: the simulator's images without its physics, so
/// that a world is lit once for many places.
class StandingRobot final : public Robot {
 public:
  StandingRobot(const simulator::World& world, const simulator::FloorPlan& plan,
                const RobotSettings& settings, std::uint64_t seed);

  /// @param place in the plan. Time goes on; odometry says 0, 0, 0 wherever it stands.
  void stand_at(const Pose2& place) { scene_.robot = place; }

  [[nodiscard]] const RobotDescription& description() const override { return description_; }
  [[nodiscard]] const Clock& clock() const override { return clock_; }
  bool sense(Senses& senses) override;
  /// The head follows at once; the wheels stand.
  void send(const MotorCommand& command) override;
  void stop() noexcept override {}

 private:
  class CycleClock final : public Clock {
   public:
    [[nodiscard]] TimePoint now() const override { return now_; }
    void advance(Duration step) { now_ += step; }

   private:
    TimePoint now_{};
  };

  RobotDescription description_;
  CycleClock clock_;
  simulator::Renderer renderer_;
  simulator::SceneState scene_;
};

}  // namespace striate::agent
