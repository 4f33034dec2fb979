#pragma once

#include <array>
#include <cstddef>
#include <numbers>

#include "striate/memory/short_term/local_grid.hpp"

namespace striate::memory {

/// The egocentric map: 72 sectors x 16 range rings round the robot, finer near it. A view that is
/// read from the evidence grid when somebody wants it (inspection, recordings, images): it never
/// holds evidence of its own, so turning does not blur it.
struct PolarMap {
  // By hand: sectors of 5 degrees; rings that grow as 1.22 times the last, as the error of a range
  // does with its square; within the window of the map, 6.4 m.
  static constexpr int kSectors = 72;
  static constexpr int kRings = 16;
  static constexpr double kInner_m = 0.30;  ///< outer edge of ring 0: about the robot's own outline
  static constexpr double kOuter_m = 6.0;   ///< outer edge of ring 15: within the window of 6.4 m
  static constexpr double kSector_rad = 2.0 * std::numbers::pi / kSectors;

  struct Cell {
    CellState state = CellState::unknown;
    float log_odds = 0.0F;  ///< of the strongest occupied part, or the mean of a free cell
    float age_s = 0.0F;     ///< since any part of it was seen; infinity: never
    float moving = 0.0F;    ///< 0 still .. 1 moving
  };

  std::array<Cell, static_cast<std::size_t>(kSectors) * kRings> cells{};

  /// Sector 0 is centred straight ahead; sectors count to the left.
  [[nodiscard]] const Cell& at(int sector, int ring) const {
    return cells[static_cast<std::size_t>(sector) * kRings + static_cast<std::size_t>(ring)];
  }
  [[nodiscard]] static int sector_of(double bearing_rad);
  [[nodiscard]] static int ring_of(double distance_m);         ///< kRings: beyond the map
  [[nodiscard]] static double ring_outer_m(int ring);          ///< each ring 1.22 times the last
  [[nodiscard]] static double sector_bearing_rad(int sector);  ///< of its middle, -pi..pi
};

/// One thing in a polar cell makes it occupied; only a cell that is nearly all seen is free.
[[nodiscard]] PolarMap read_polar_map(const LocalGrid& grid, const Pose2& robot, TimePoint now);

}  // namespace striate::memory
