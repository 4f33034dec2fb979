#pragma once

#include <memory>
#include <string>
#include <vector>

#include "striate/platform/interface/robot.hpp"
#include "striate/platform/simulator/scene.hpp"

namespace striate::simulator {

/// One person's place in the physics: the same index is always the same person.
struct PersonBody {
  bool present = false;
  Point2 at;
  double velocity_x_m_s = 0.0;
  double velocity_y_m_s = 0.0;
};

/// Something that the robot touches now.
struct Touch {
  std::string name;     ///< "wall", "pillar_1", "table_1", "person_2"
  bool moving = false;  ///< a person who walks
};

/// What a range finder sends out: glass throws back sound, and lets light through.
enum class Beam { sound, light };

/// What a ray of a range finder meets.
struct RayHit {
  double distance_m = 0.0;     ///< +inf: nothing
  double cos_incidence = 1.0;  ///< 1: straight onto the surface
  bool smooth = false;         ///< a wall or glass, which throws sound away like a mirror
};

/// The flat physics of a run (Box2D): the robot's octagon, everything that stands, people as
/// kinematic discs. Coordinates of the plan.
class Physics {
 public:
  Physics(const World& world, const FloorPlan& plan, const RobotDescription& robot, Pose2 start,
          std::size_t people);
  ~Physics();
  Physics(const Physics&) = delete;
  Physics& operator=(const Physics&) = delete;

  /// Moves everything on by `dt_s`: the robot as its wheels turn, as far as nothing is in the way.
  void step(double dt_s, double forward_m_s, double turn_rad_s,
            const std::vector<PersonBody>& people);

  /// More obstacles stand there from now on.
  void add_obstacles(const World& new_ones, const FloorPlan& plan);

  /// Puts the robot elsewhere, as a hand does that lifts it; it goes on as fast as it went.
  void put_robot(const Pose2& pose);

  [[nodiscard]] Pose2 robot() const;
  /// How fast the robot really went in the last step; forward and turning.
  [[nodiscard]] double forward_m_s() const;
  [[nodiscard]] double turn_rad_s() const;
  [[nodiscard]] std::vector<Touch> touches() const;

  /// Follows a ray at the height of the range finders (0.2 m to 0.3 m), where tables and chairs
  /// are legs; never sees the robot itself.
  [[nodiscard]] RayHit ray(Point2 from, double heading_rad, double range_m, Beam beam) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace striate::simulator
