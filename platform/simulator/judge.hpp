#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "striate/platform/simulator/image_source.hpp"
#include "striate/platform/simulator/people.hpp"
#include "striate/platform/simulator/physics.hpp"
#include "striate/platform/simulator/simulator_settings.hpp"
#include "striate/platform/simulator/static_shapes.hpp"

/// The truth about a run, for judging alone: nothing that sees, remembers, wants or moves may ask.
namespace striate::simulator {

enum class Verdict { running, reached_goal, collided, time_up };

struct Collision {
  double time_s = 0.0;
  double along_m = 0.0;  ///< where the axle was, in corridor coordinates
  double left_m = 0.0;
  /// "wall", "pillar_1", "table_1", "person_2"; "drop of stairs_1": it has fallen down there
  std::string hit;
  bool moving = false;       ///< what was hit moved
  double light_level = 1.0;  ///< there
  double forward_m_s = 0.0;  ///< the robot's speed when it touched
};

/// Somewhere the robot came nearer than 10 cm to something without touching it.
struct NearMiss {
  double time_s = 0.0;
  double along_m = 0.0;
  double left_m = 0.0;
  double clearance_m = 0.0;
  std::string to;
  bool moving = false;
};

struct PathPoint {
  double time_s = 0.0;
  Pose2 pose;  ///< in the plan
};

struct PeopleAt {
  double time_s = 0.0;
  std::vector<Pose2> people;  ///< in the plan
};

class Judge {
 public:
  Judge(const World& world, const FloorPlan& plan, const RobotDescription& robot,
        const JudgeSettings& settings);

  /// More obstacles stand there from now on.
  void add_obstacles(const World& new_ones);

  /// Looks at the moment; call every physics step. `light` may be null.
  void look(double now_s, const Physics& physics, const People& people, const ImageSource* light);

  [[nodiscard]] Verdict outcome() const { return outcome_; }
  /// The settings say that the run ends here.
  [[nodiscard]] bool over() const { return over_; }
  [[nodiscard]] const PathPoint& now() const { return now_; }  ///< the true pose
  [[nodiscard]] Pose2 in_corridor() const { return plan_.along(now_.pose); }
  [[nodiscard]] bool reached_goal() const { return reached_goal_; }
  [[nodiscard]] double distance_driven_m() const { return driven_m_; }
  /// Smallest distance from the footprint to anything while nothing was touched.
  [[nodiscard]] double nearest_pass_m() const { return nearest_pass_m_; }
  [[nodiscard]] double clearance_m() const { return clearance_m_; }  ///< now; 0: touching
  [[nodiscard]] bool touching() const { return clearance_m_ <= 0.0; }
  [[nodiscard]] const std::vector<Collision>& collisions() const { return collisions_; }
  [[nodiscard]] const std::vector<NearMiss>& near_misses() const { return near_misses_; }
  [[nodiscard]] const std::vector<PathPoint>& path() const { return path_; }     ///< each 0.2 s
  [[nodiscard]] const std::vector<PeopleAt>& people() const { return people_; }  ///< each 0.5 s

 private:
  struct Nearest {
    double clearance_m = std::numeric_limits<double>::infinity();
    std::string name;
    bool moving = false;
  };
  void note_path(double now_s, const Physics& physics, const People& people);
  void note_touches(double now_s, const std::vector<Touch>& touches, const ImageSource* light);
  void note_touching();
  /// The stairs that a wheel has gone over the edge of; "": none.
  [[nodiscard]] std::string fallen_into() const;
  void note_clearance(double now_s, const Nearest& nearest);
  [[nodiscard]] Nearest nearest_thing(const People& people) const;
  void decide(double now_s);

  FloorPlan plan_;
  std::vector<StaticShape> things_;
  std::vector<StaticShape> drops_;
  ConvexShape footprint_;
  std::array<Point2, 3> wheels_;  ///< where the base stands on the floor, from the axle
  JudgeSettings settings_;
  double goal_beyond_m_;

  Verdict outcome_ = Verdict::running;
  bool over_ = false;
  std::uint64_t looks_ = 0;
  bool reached_goal_ = false;
  PathPoint now_;
  bool started_ = false;
  double driven_m_ = 0.0;
  double forward_m_s_ = 0.0;  ///< before this step: a touch has taken it already
  double clearance_m_ = std::numeric_limits<double>::infinity();
  double nearest_pass_m_ = std::numeric_limits<double>::infinity();
  std::vector<Collision> collisions_;
  struct Held {
    std::string name;
    double last_s = 0.0;
  };
  std::vector<Held> held_;  ///< what is or was just touched: one collision each
  std::vector<NearMiss> near_misses_;
  bool near_ = false;
  NearMiss nearing_;
  std::vector<PathPoint> path_;
  std::vector<PeopleAt> people_;
};

}  // namespace striate::simulator
