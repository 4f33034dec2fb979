#include "striate/memory/localisation/obstacle_grid.hpp"

#include <algorithm>
#include <cmath>

#include "striate/base/index_within.hpp"

namespace striate::memory {
namespace {

std::int32_t cell_of(double metres) {
  return cell_below(metres / kObstacleCell_m);
}

}  // namespace

void ObstacleGrid::start() {
  slots_.assign(kSlots, {});
  size_ = 0;
  changed_ = 0;
}

void ObstacleGrid::know(const ObstacleCell& cell) {
  if (Slot* slot = claim(cell.column, cell.row)) {
    slot->log_odds = std::clamp(static_cast<float>(cell.log_odds), -kMostLogOdds, kMostLogOdds);
  }
}

void ObstacleGrid::add(Point2 map, float log_odds) {
  Slot* slot = claim(cell_of(map.x_m), cell_of(map.y_m));
  if (slot == nullptr) return;
  const float sum = std::clamp(slot->log_odds + log_odds, -kMostLogOdds, kMostLogOdds);
  if (sum == slot->log_odds) return;
  slot->log_odds = sum;
  if (!slot->changed) ++changed_;
  slot->changed = true;
}

float ObstacleGrid::log_odds(Point2 map) const {
  if (slots_.empty()) return 0.0F;
  const Slot& slot = slots_[slot_of(cell_of(map.x_m), cell_of(map.y_m))];
  return slot.used ? slot.log_odds : 0.0F;
}

/// The slot of a cell, or the free one where it belongs: there always is one (kMostCells).
std::size_t ObstacleGrid::slot_of(std::int32_t column, std::int32_t row) const {
  // Fibonacci hashing of both numbers (Knuth).
  const std::uint64_t both =
      (static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32) |
      static_cast<std::uint32_t>(row);
  std::size_t slot = static_cast<std::size_t>((both * 0x9E3779B97F4A7C15ull) >> 32) % kSlots;
  while (slots_[slot].used && (slots_[slot].column != column || slots_[slot].row != row)) {
    slot = (slot + 1) % kSlots;
  }
  return slot;
}

ObstacleGrid::Slot* ObstacleGrid::claim(std::int32_t column, std::int32_t row) {
  Slot& slot = slots_[slot_of(column, row)];
  if (slot.used) return &slot;
  if (size_ >= kMostCells) return nullptr;
  ++size_;
  slot = {column, row, 0.0F, true, false};
  return &slot;
}

}  // namespace striate::memory
