#pragma once

#include <cstdint>
#include <memory>

#include "striate/platform/interface/robot.hpp"
#include "striate/platform/simulator/image_source.hpp"
#include "striate/platform/simulator/judge.hpp"
#include "striate/platform/simulator/late_obstacles.hpp"
#include "striate/platform/simulator/simulator_settings.hpp"
#include "striate/platform/simulator/world.hpp"

namespace striate::simulator {

/// The default body: a Pioneer 3-DX in a corridor that exists only here. Its clock stands still
/// between two calls of sense(), so a run is as fast as the machine, and the same world, seed and
/// commands give the same senses, bit for bit. Nothing is shared between two of them: many can run
/// in threads of one program.
class SimulatedPioneer : public Robot {
 public:
  /// `images` may be null: then no image ever comes. It must outlive the robot.
  SimulatedPioneer(const World& world, std::uint64_t seed, const SimulatorSettings& settings,
                   ImageSource* pictures, const RobotDescription& robot = {});
  ~SimulatedPioneer() override;

  [[nodiscard]] const RobotDescription& description() const override;
  [[nodiscard]] const Clock& clock() const override;

  /// Lets one cycle (100 ms) pass in the corridor. False: the run is over; `senses` is filled
  /// then, too.
  bool sense(Senses& senses) override;
  void send(const MotorCommand& command) override;
  void stop() noexcept override;

  /// The truth, for judging alone.
  [[nodiscard]] const Judge& judge() const;
  /// Everything that moves, as it is now: for images of the run.
  [[nodiscard]] SceneState scene() const;
  [[nodiscard]] const FloorPlan& plan() const;
  [[nodiscard]] const LateObstacles& late_obstacles() const;

  /// For devices with a sweep of their own: one ray from the laser, +inf beyond its range.
  /// @param bearing_rad counter-clockwise from ahead, all around
  [[nodiscard]] double laser_range_m(double bearing_rad);
  /// Puts the robot elsewhere, as a hand does that lifts it: no wheel turns.
  /// @return false where it would stand outside of the walls or in a thing: it stays where it is
  bool put_at(const Pose2& pose);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace striate::simulator
