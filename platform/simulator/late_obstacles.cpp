#include "striate/platform/simulator/late_obstacles.hpp"

#include <algorithm>
#include <cmath>

namespace striate::simulator {

std::vector<std::size_t> late_obstacles_of(const World& world) {
  std::vector<std::size_t> late;
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    if (comes_late(world.obstacles[i])) late.push_back(i);
  }
  return late;
}

LateObstacles::LateObstacles(const World& world, const FloorPlan& plan)
    : absent_(late_obstacles_of(world)) {
  for (const WorldObstacle& obstacle : world.obstacles) {
    const Pose2 at = plan.at(obstacle.at.x_m, obstacle.at.y_m);
    dues_.push_back({obstacle.from_s, obstacle.appears_after_m, {at.x_m, at.y_m}});
  }
  fresh_.reserve(absent_.size());
  put_down_.reserve(absent_.size());
}

const std::vector<std::size_t>& LateObstacles::step(double now_s, double driven_m,
                                                    const Pose2& robot) {
  fresh_.clear();
  for (const std::size_t i : absent_) {
    const Due& due = dues_[i];
    const bool far = std::hypot(due.at.x_m - robot.x_m, due.at.y_m - robot.y_m) > kLeast_m;
    if (now_s >= due.from_s && driven_m >= due.after_m && far) fresh_.push_back(i);
  }
  for (const std::size_t i : fresh_) put_down_.push_back({i, now_s, driven_m});
  if (!fresh_.empty()) {
    std::erase_if(absent_, [&](std::size_t i) {
      return std::find(fresh_.begin(), fresh_.end(), i) != fresh_.end();
    });
  }
  return fresh_;
}

World world_without(const World& world, const std::vector<std::size_t>& absent) {
  World left = world;
  left.obstacles.clear();
  for (std::size_t i = 0; i < world.obstacles.size(); ++i) {
    if (std::find(absent.begin(), absent.end(), i) == absent.end()) {
      left.obstacles.push_back(world.obstacles[i]);
    }
  }
  return left;
}

World world_with_only(const World& world, const std::vector<std::size_t>& present) {
  World left = world;
  left.pillars.clear();
  left.obstacles.clear();
  for (const std::size_t i : present) left.obstacles.push_back(world.obstacles[i]);
  return left;
}

}  // namespace striate::simulator
