#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "striate/behaviours/control/floor_field.hpp"
#include "striate/memory/short_term/short_term_memory.hpp"

namespace striate::behaviours {

/// A way over the floor in the odometry frame, from the robot on.
struct Path {
  static constexpr std::size_t kCapacity = 200;  ///< points: four times the 48 steps ahead
  bool found = false;
  bool reaches_far = false;  ///< to the far side of what was planned over; else it ends before
  std::size_t count = 0;
  std::array<Point2, kCapacity> points{};
  double progress_m = 0.0;      ///< of its end along the wanted direction
  double least_margin_m = 0.0;  ///< least clearance beside the robot's flanks on it
};

/// Where to go.
struct PlanRequest {
  double direction_rad = 0.0;  ///< in the odometry frame: the corridor's axis, or back along it
  double wanted_left_m = 0.0;  ///< the line to keep, to the left of the robot's place
  double half_width_m = 0.0;   ///< of the robot
  double least_margin_m = 0.0;
  double left_wall_m = perception::kNothing_m;  ///< remembered walls, as seen along the direction
  double right_wall_m = perception::kNothing_m;
  double middle_left_m = 0.0;  ///< the corridor's middle, to the left of the robot
  double half_corridor_m = perception::kNothing_m;  ///< half its width as far as is known
  bool corridor_sure = false;  ///< its place is known well: nothing leads outside
};

/// Dijkstra over a 0.1 m grid laid along the corridor, 5 m ahead and 3 m to each side. The cost of
/// a metre grows near things, over unknown floor and off the wanted line, and falls a little
/// along the way chosen before, so that the choice of a side does not flicker. Fixed memory.
class PathPlanner {
 public:
  static constexpr double kStep_m = 0.10;  ///< by hand: two patches of the map
  // Cells: 0.6 m, 4.8 m and 2.8 m. By hand, within FloorField::kReach: room to come out of a
  // corner, as far as stereo is trusted (5.5 m), and a corridor of 2.4 m from wall to wall.
  static constexpr int kBehind = 6;
  static constexpr int kAhead = 48;
  static constexpr int kAside = 28;
  static constexpr int kLong = kBehind + kAhead + 1;
  static constexpr int kWide = 2 * kAside + 1;

  PathPlanner();
  const Path& plan(const FloorField& field, const Pose2& robot, const PlanRequest& request);
  void forget_choice() { way_.found = false; }
  [[nodiscard]] const Path& way() const { return way_; }

 private:
  struct Queued {
    float cost;
    int node;
  };
  static constexpr int kNodes = kLong * kWide;
  [[nodiscard]] static double advance_of(int node);  ///< along the wanted direction
  [[nodiscard]] Point2 place_of(int node) const;     // odometry frame
  void mark_last_path();
  void price(const FloorField& field, const PlanRequest& request);
  [[nodiscard]] float price_of(const FloorField& field, const PlanRequest& request, int node) const;
  void spread();
  void relax(int node, float cost, int along, int aside);
  [[nodiscard]] int best_end() const;
  void trace(int end, const FloorField& field, const PlanRequest& request);

  Pose2 frame_;
  std::vector<float> price_;  // of a metre; < 0: closed
  std::vector<float> cost_;
  std::vector<int> from_;
  std::vector<std::uint8_t> chosen_;
  std::vector<Queued> queue_;
  Path way_;
};

}  // namespace striate::behaviours
