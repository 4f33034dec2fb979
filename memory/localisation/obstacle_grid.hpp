#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "striate/base/geometry.hpp"
#include "striate/memory/long_term/records.hpp"

namespace striate::memory {

/// The allocentric obstacle grid: log-odds of cells of kObstacleCell_m in the map's frame, in a
/// hash table of fixed size. What does not fit is not kept: growth is bounded.
class ObstacleGrid {
 public:
  static constexpr std::size_t kSlots = std::size_t{1}
                                        << 17;               ///< by hand: 2 MB of slots of 16 bytes
  static constexpr std::size_t kMostCells = kSlots / 4 * 3;  ///< fuller, searches grow long; 983 m2
  static constexpr float kMostLogOdds = 6.0F;  ///< by hand: a few missions, not many, change a cell

  /// Allocates.
  void start();
  void know(const ObstacleCell& cell);
  void add(Point2 map, float log_odds);
  [[nodiscard]] float log_odds(Point2 map) const;  ///< 0: unknown
  [[nodiscard]] std::size_t size() const { return size_; }

  /// Takes the cells that have changed since they were taken last, at most so many.
  template <class Sink>
  void take_changed(std::size_t most, Sink sink) {
    for (std::size_t slot = 0; slot < slots_.size() && changed_ > 0 && most > 0; ++slot) {
      Slot& one = slots_[slot];
      if (!one.used || !one.changed) continue;
      one.changed = false;
      --changed_;
      --most;
      sink(one.column, one.row, one.log_odds);
    }
  }

 private:
  struct Slot {
    std::int32_t column = 0;
    std::int32_t row = 0;
    float log_odds = 0.0F;
    bool used = false;
    bool changed = false;
  };
  [[nodiscard]] std::size_t slot_of(std::int32_t column, std::int32_t row) const;
  /// nullptr where there is no room.
  Slot* claim(std::int32_t column, std::int32_t row);

  std::vector<Slot> slots_;
  std::size_t size_ = 0;
  std::size_t changed_ = 0;
};

}  // namespace striate::memory
