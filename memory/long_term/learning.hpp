#pragma once

#include <cstdint>
#include <unordered_map>

#include "striate/base/geometry.hpp"
#include "striate/memory/long_term/long_term_settings.hpp"
#include "striate/memory/long_term/memory_tables.hpp"

namespace striate::memory {

/// Decides which looks teach something. A landmark that is seen again from where it was seen is the
/// same use, and one that is missed from where it was missed the same miss, so a robot that stands
/// still adds nothing; a miss counts once several frames in a row should have shown it. Part of the
/// cycle: touches no disk.
class Learning {
 public:
  explicit Learning(const LongTermSettings& settings) : settings_(settings) {}

  /// It was recognised in this frame, confirmed or not: what was missed before was no row.
  void found(std::int64_t landmark) { known_[landmark].missed_frames = 0; }
  /// A confirmed sighting. @return whether it is a new use, to be kept by `keep_sighting`.
  [[nodiscard]] bool seen(std::int64_t landmark, const Point2& from);
  /// Predicted in view, within range, hidden by nothing, and not seen in this frame.
  /// @return whether it is a missed opportunity, to be kept by `keep_miss`.
  [[nodiscard]] bool missed(std::int64_t landmark, const Point2& from);

 private:
  struct KnownViews {
    bool used = false;
    Point2 used_from;
    bool was_missed = false;  ///< since it was used last
    Point2 missed_from;
    int missed_frames = 0;
  };
  [[nodiscard]] bool same_place(const Point2& a, const Point2& b) const;

  LongTermSettings settings_;
  std::unordered_map<std::int64_t, KnownViews> known_;
};

/// For the writer's thread, within a transaction. A landmark that is gone is left out.
void keep_sighting(MemoryTables& tables, const std::string& name, double now_s,
                   const LongTermSettings& settings);
void keep_miss(MemoryTables& tables, const std::string& name, const LongTermSettings& settings);

}  // namespace striate::memory
