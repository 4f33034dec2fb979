#pragma once

#include <cstddef>
#include <vector>

#include "striate/platform/simulator/scene.hpp"

namespace striate::simulator {

/// Obstacles that are not there at first: somebody puts them down during the run, after a time or
/// after the robot has driven so far. Never near the robot: what is due waits until the robot is
/// farther off than it needs to see it and to stop.
class LateObstacles {
 public:
  /// Between the robot's axle and the obstacle's middle. Stopping from 0.75 m/s takes 0.6 m, and
  /// the latency of the eyes 0.3 m more.
  static constexpr double kLeast_m = 3.0;

  LateObstacles(const World& world, const FloorPlan& plan);

  /// Puts down what is due. Returns the obstacles that are new, by their place in
  /// `World::obstacles`; most often none.
  const std::vector<std::size_t>& step(double now_s, double driven_m, const Pose2& robot);
  /// Those that are not there yet.
  [[nodiscard]] const std::vector<std::size_t>& absent() const { return absent_; }
  /// Those that were put down during the run, in that order.
  struct PutDown {
    std::size_t obstacle;  ///< its place in `World::obstacles`
    double time_s;
    double driven_m;  ///< by the robot until then
  };
  [[nodiscard]] const std::vector<PutDown>& put_down() const { return put_down_; }

 private:
  struct Due {
    double from_s;
    double after_m;
    Point2 at;  ///< in the plan
  };
  std::vector<Due> dues_;  // of all obstacles
  std::vector<std::size_t> absent_;
  std::vector<std::size_t> fresh_;
  std::vector<PutDown> put_down_;
};

/// It is not there at first.
[[nodiscard]] inline bool comes_late(const WorldObstacle& obstacle) {
  return obstacle.from_s > 0.0 || obstacle.appears_after_m > 0.0;
}
/// By their place in `World::obstacles`.
[[nodiscard]] std::vector<std::size_t> late_obstacles_of(const World& world);
/// The world without some of its obstacles.
[[nodiscard]] World world_without(const World& world, const std::vector<std::size_t>& absent);
/// The world with these of its obstacles alone, and without pillars.
[[nodiscard]] World world_with_only(const World& world, const std::vector<std::size_t>& present);

}  // namespace striate::simulator
