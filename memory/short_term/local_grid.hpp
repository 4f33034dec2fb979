#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "striate/base/geometry.hpp"
#include "striate/base/time.hpp"

namespace striate::memory {

/// What is known about a patch of floor. Unknown is never free.
enum class CellState : std::uint8_t { unknown, free, occupied };

/// A cell by its whole-cell coordinates in the odometry frame.
struct GridCell {
  int x = 0;
  int y = 0;
  friend bool operator==(const GridCell&, const GridCell&) = default;
};

/// The evidence about the floor round the robot: a grid that scrolls with the robot by whole cells
/// but stays aligned with the odometry frame. A polar grid turned by every new heading would be
/// resampled, and so blurred, ten times a second; this one never is. Fixed memory.
class LocalGrid {
 public:
  static constexpr int kSide = 256;        ///< a power of two: storage wraps round; 6.4 m each way
  static constexpr double kCell_m = 0.05;  ///< by hand: a range errs by as much from 1.9 m on
  // Log-odds, by hand (README.md), counted in the looks of OccupancySettings: one full look at
  // floor makes a cell free, two at a thing make it occupied.
  static constexpr float kFreeBelow = -0.5F;
  static constexpr float kOccupiedAbove = 1.2F;
  // Bounds, by hand: no more than six looks at floor and four at a thing are kept, so that what is
  // gone is cleared within five: Evidence.WhatIsGoneIsClearedWithinTwoSeconds.
  static constexpr float kLeast = -3.0F;
  static constexpr float kMost = 3.5F;
  static constexpr float kSurelyOccupied = 3.0F;  ///< four looks: counts even as a lone speck
  static constexpr int kReach = kSide / 2 - 2;    ///< cells that surely lie inside, each way

  LocalGrid();

  /// Moves the window so that `odometry` lies in its middle; what comes in is unknown.
  void centre_on(Point2 odometry);

  [[nodiscard]] static GridCell cell_of(Point2 odometry);
  [[nodiscard]] static Point2 centre_of(GridCell cell);
  [[nodiscard]] bool holds(GridCell cell) const;
  /// The corner that the window has when it is centred there.
  [[nodiscard]] static GridCell first_around(Point2 odometry);
  [[nodiscard]] GridCell first() const { return first_; }  ///< the corner with least x and y

  [[nodiscard]] float log_odds(GridCell cell) const;       ///< 0 outside the window
  [[nodiscard]] float moving(GridCell cell) const;         ///< 0 still .. 1 moving
  [[nodiscard]] TimePoint last_seen(GridCell cell) const;  ///< zero: never
  [[nodiscard]] CellState state(GridCell cell) const;
  /// Occupied, and no mere speck: with two occupied neighbours or more, or strong evidence.
  /// Single wrong matches are common, and thin things are seen again and again.
  [[nodiscard]] bool stands(GridCell cell) const;

  /// Adds evidence and notes the time. A cell outside is ignored.
  void add(GridCell cell, float log_odds, TimePoint seen);
  void set_moving(GridCell cell, float moving);
  /// Highest part seen of what stands here, metres above the floor; 0 where never seen.
  [[nodiscard]] float height_m(GridCell cell) const;
  void raise_to(GridCell cell, float height_m);
  /// Height of the lowest part of what hangs over the floor here, metres; 0: it stands on it.
  [[nodiscard]] float hangs_from_m(GridCell cell) const;
  void hang_from(GridCell cell, float height_m);
  /// The floor under the robot itself: certainly free.
  void clear(GridCell cell, TimePoint seen);

  /// Multiplies evidence: one factor each for what is free, what stands, and what moves.
  struct Fade {
    float free = 1.0F;
    float occupied = 1.0F;
    float moving = 1.0F;
  };
  void fade(const Fade& factor);

  /// Odometry drifts: evidence not renewed since `before` leaks into its four neighbours by
  /// `share` (0..0.5), so that old edges become soft.
  void blur_older_than(TimePoint before, float share);

  void forget();

 private:
  struct Stored {
    float log_odds = 0.0F;
    float moving = 0.0F;
    float height_m = 0.0F;
    float hangs_from_m = 0.0F;
    std::int32_t seen_ms = 0;
  };
  [[nodiscard]] static std::size_t index(GridCell cell) {
    return static_cast<std::size_t>(cell.y & (kSide - 1)) * kSide +
           static_cast<std::size_t>(cell.x & (kSide - 1));
  }
  void forget_column(int x);
  void forget_row(int y);

  std::vector<Stored> cells_;
  std::vector<float> scratch_;
  GridCell first_{-kSide / 2, -kSide / 2};
};

}  // namespace striate::memory
