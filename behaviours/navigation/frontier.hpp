#pragma once

#include <array>
#include <bitset>
#include <cstddef>
#include <vector>

#include "striate/behaviours/control/floor_field.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::behaviours {

/// Floor that was known once in this run. Short-term memory fades within a minute; this is only
/// whether, not what: squares of 0.25 m, a bit each, over 64 m x 64 m that wrap round.
class KnownFloor {
 public:
  static constexpr double kSquare_m = 0.25;  ///< by hand: five patches of the map each way
  static constexpr int kSide = 256;          ///< squares, 64 m; a power of two: indices wrap round
  void forget() { known_.reset(); }
  void know(Point2 odometry) { known_.set(index(odometry)); }
  [[nodiscard]] bool knows(Point2 odometry) const { return known_.test(index(odometry)); }
  [[nodiscard]] double area_m2() const {
    return static_cast<double>(known_.count()) * kSquare_m * kSquare_m;
  }

 private:
  [[nodiscard]] static std::size_t index(Point2 odometry);
  std::bitset<static_cast<std::size_t>(kSide) * kSide> known_;
};

/// A place at the edge of what is known that the robot can drive to.
struct Frontier {
  bool found = false;
  Point2 place;             ///< odometry frame
  Point2 next;              ///< a point some metres on along the way there
  double way_m = 0.0;       ///< length of the way
  double unknown_m2 = 0.0;  ///< round it
};

/// Finds where the map ends within the robot's reach (Yamauchi 1997): a search over 0.1 m squares
/// through free floor as wide as the robot; of the places it gets to, the one is best round which
/// most is unknown for the way and the turning that it costs. Fixed memory.
class FrontierFinder {
 public:
  static constexpr double kStep_m = 0.10;  ///< that of the planned way, PathPlanner::kStep_m
  static constexpr int kReach = 52;        ///< squares each way, 5.2 m: within FloorField::kReach

  explicit FrontierFinder(const RobotDescription& robot);
  void forget();
  /// Notes what the map knows; call it often, the map fades.
  void note(const FloorField& field, const Pose2& robot);
  [[nodiscard]] Frontier find(const FloorField& field, const Pose2& robot);
  /// There is nothing to be found here; not proposed again.
  void avoid(Point2 place);
  void forget_avoided() { avoided_count_ = 0; }
  /// The last choice is preferred while it is nearly as good.
  void prefer(Point2 place) { preferred_ = place; }
  /// Floor round a place that was never known and that the robot could drive on.
  [[nodiscard]] double unknown_round_m2(const FloorField& field, Point2 place) const;
  [[nodiscard]] bool avoided(Point2 place) const;
  [[nodiscard]] const KnownFloor& known() const { return known_; }

 private:
  static constexpr int kSide = 2 * kReach + 1;
  static constexpr std::size_t kAvoided = 48;  ///< by hand; when it is full the first gives way
  [[nodiscard]] Point2 place_of(int node) const;
  [[nodiscard]] bool open(const FloorField& field, Point2 place, const Pose2& robot) const;
  void spread(const FloorField& field, const Pose2& robot);
  [[nodiscard]] Point2 next_on_path(int node) const;

  double half_width_m_;
  Point2 middle_;
  KnownFloor known_;
  std::vector<float> way_m_;  // < 0: not reached
  std::vector<int> from_;
  std::vector<int> queue_;
  std::array<Point2, kAvoided> avoided_{};
  std::size_t avoided_count_ = 0;
  Point2 preferred_;
};

}  // namespace striate::behaviours
