#pragma once

#include <string>
#include <vector>

#include "striate/platform/simulator/physics.hpp"
#include "striate/platform/simulator/stepper.hpp"
#include "striate/platform/simulator/walker.hpp"

namespace striate::simulator {

/// What people see of the robot.
struct RobotMotion {
  Pose2 pose;
  double forward_m_s = 0.0;
  double turn_rad_s = 0.0;
};

/// Everybody in the corridor: those who walk, those who step in front of the robot, those who
/// stand. Each has a slot of his own for the whole run, present or not.
class People {
 public:
  People(const World& world, const FloorPlan& plan, const RobotDescription& robot,
         std::uint64_t seed);
  People(const People&) = delete;
  People& operator=(const People&) = delete;

  /// Moves everybody on by `dt_s`, to the time `now_s`.
  void step(double now_s, double dt_s, const RobotMotion& robot);

  [[nodiscard]] const std::vector<PersonState>& slots() const { return slots_; }
  [[nodiscard]] bool present(std::size_t slot) const { return bodies_[slot].present; }
  [[nodiscard]] std::string name(std::size_t slot) const;
  /// Those who are there now.
  [[nodiscard]] std::vector<PersonState> states() const;
  /// Where everybody was before the last step and how he moved in it, for the physics.
  [[nodiscard]] const std::vector<PersonBody>& bodies() const { return bodies_; }

 private:
  struct Walking {
    std::size_t slot = 0;
    std::vector<Point2> way;
    double speed_m_s = 1.0;
    double from_s = 0.0;
    bool repeat = false;
    bool leaving = false;
    bool yielding = false;  ///< went back a little to let the robot pass
    double yielded_at_s = -1e9;
    std::vector<Point2> after;  ///< the way that he goes on with after yielding
    std::vector<Point2> after_doors;
    bool done = false;
    int look = 0;
    Walker walker;
  };
  void add_walks(std::uint64_t seed);
  void decide(double now_s);
  void decide_walk(Walking& walking, double now_s);
  [[nodiscard]] bool appear(Walking& walking, double now_s);
  void end_of_path(Walking& walking);
  void yield(Walking& walking, double now_s);
  void look_round(const RobotMotion& robot);
  void see_others(std::size_t slot);
  [[nodiscard]] Walker* walker_of(std::size_t slot);
  void publish(double dt_s);

  World world_;
  FloorPlan plan_;
  ClearanceMap map_;
  std::vector<Doorway> doors_;
  RobotNearby place_;
  std::vector<Walking> walks_;
  std::vector<Stepper> steppers_;
  std::vector<Walker> standers_;
  Surroundings around_;
  std::vector<PersonState> slots_;
  std::vector<PersonBody> bodies_;
  std::uint64_t steps_ = 0;
};

}  // namespace striate::simulator
