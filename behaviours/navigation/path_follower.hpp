#pragma once

#include <cstdint>

#include "striate/behaviours/control/floor_field.hpp"
#include "striate/behaviours/control/wish.hpp"
#include "striate/behaviours/navigation/path_planner.hpp"
#include "striate/behaviours/navigation/speed_limits.hpp"
#include "striate/behaviours/navigation/steering.hpp"

namespace striate::behaviours {

/// How the way is driven; shared by all behaviours that go somewhere. By hand (README.md, "Where
/// the numbers come from").
struct DrivingSettings {
  double least_margin_m = 0.06;      ///< gaps of 0.75 m pass, 0.50 m do not: Planning.TakesAGap...
  double wanted_clearance_m = 0.12;  ///< twice the least
  double patience_s = 3.0;           ///< people pass: TraverseCorridor.WaitsForSomeone...
  double stuck_after_s = 15.0;       ///< longer than waiting (3 s) and looking round (4 s) take
  double back_m = 0.35;              ///< room to turn the front, 0.21 m before the axle
  int tries = 6;
  SpeedLimitSettings speed_limit;
};

template <class V>
void visit(V& v, DrivingSettings& s) {
  using config::Unit;
  v.number("least_margin", s.least_margin_m, Unit::length, {0.0, 0.5},
           "room that a gap must leave on each side");
  v.number("wanted_clearance", s.wanted_clearance_m, Unit::length, {0.02, 0.6},
           "room that is kept where there is room");
  v.number("patience", s.patience_s, Unit::duration, {0, 120},
           "waits so long before a blocked way before it looks round");
  v.number("stuck_after", s.stuck_after_s, Unit::duration, {3, 300},
           "no headway for so long is trouble");
  v.number("back", s.back_m, Unit::length, {0, 2}, "backs out so far where no gap is left");
  v.integer("tries", s.tries, {1, 50}, "troubles in one place before it gives up");
  v.renamed("pace", "speed_limit");
  v.section("speed_limit", s.speed_limit);
}

/// Where to go: along a direction, keeping a line.
struct Course {
  double direction_rad = 0.0;  ///< odometry frame
  double wanted_left_m = 0.0;  ///< the line to keep, to the left of the robot
  double cruise_m_s = 0.45;
  double left_wall_m = perception::kNothing_m;
  double right_wall_m = perception::kNothing_m;
  double middle_left_m = 0.0;  ///< the corridor's middle, to the left of the robot
  double half_corridor_m = perception::kNothing_m;  ///< half its width
  bool corridor_sure = false;                       ///< its middle and width are known well
};

/// Plans on the map, follows the way, and gets out of trouble: waits for what may pass, looks
/// round, backs out, tries again; gives up with a reason after repeated trouble in one place.
class PathFollower {
 public:
  PathFollower(const DrivingSettings& settings, const RobotDescription& robot);
  void start(const memory::ShortTermMemory& memory);
  Wish tick(const memory::ShortTermMemory& memory, const Course& course);

  [[nodiscard]] const Path& way() const { return planner_.way(); }
  [[nodiscard]] const FloorField& field() const { return field_; }
  /// Path made along the courses' directions since the start.
  [[nodiscard]] double headway_m() const { return headway_m_; }

 private:
  enum class State : std::uint8_t { driving, waiting, looking, backing };
  void measure_headway(const memory::ShortTermMemory& memory, const Course& course);
  Wish drive(const memory::ShortTermMemory& memory, const Course& course);
  Wish wait(const memory::ShortTermMemory& memory, const Course& course);
  [[nodiscard]] Drive steer(const memory::ShortTermMemory& memory, const Course& course,
                            double speed_m_s) const;
  Wish look(const memory::ShortTermMemory& memory);
  Wish back(const memory::ShortTermMemory& memory);
  [[nodiscard]] bool is_held(const memory::ShortTermMemory& memory);
  [[nodiscard]] bool feels_something(const memory::ShortTermMemory& memory) const;
  [[nodiscard]] bool may_back_to(const Pose2& behind, const memory::ShortTermMemory& memory) const;
  void leave_what_was_felt(const memory::ShortTermMemory& memory);
  void note_trouble(const memory::ShortTermMemory& memory);
  void enter(State state, const memory::ShortTermMemory& memory);
  [[nodiscard]] bool path_is_open() const;
  [[nodiscard]] double least_margin_m() const;
  [[nodiscard]] double since_entered_s(const memory::ShortTermMemory& memory) const;
  void aim_head(const memory::ShortTermMemory& memory, const SpeedLimit& speed_limit, Wish& wish);
  [[nodiscard]] bool glances_down(const memory::ShortTermMemory& memory,
                                  const SpeedLimit& speed_limit, double speed_m_s);

  DrivingSettings settings_;
  RobotDescription robot_;
  double look_down_rad_;    ///< tilt that shows the floor before the wheels
  double glance_down_rad_;  ///< tilt half as far down
  double pan_driving_rad_;  ///< the head's farthest turn while driving
  FloorField field_;
  PathPlanner planner_;
  Steering steering_;

  State state_ = State::driving;
  TimePoint entered_{};
  Pose2 entered_pose_;
  double back_m_ = 0.0;  ///< so far it backs out this time
  int troubles_ = 0;
  double headway_m_ = 0.0;
  double best_headway_m_ = 0.0;
  double trouble_headway_m_ = 0.0;
  TimePoint best_headway_at_{};
  Pose2 last_pose_;
  TimePoint impossible_since_{};
  TimePoint look_down_until_{};
  TimePoint glance_until_{};
  Pose2 glanced_at_;
  TimePoint mover_since_{};
  TimePoint free_to_move_at_{};  ///< last moved, or did not wish to
};

}  // namespace striate::behaviours
