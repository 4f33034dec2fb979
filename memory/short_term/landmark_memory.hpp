#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "striate/base/fixed_text.hpp"
#include "striate/base/geometry.hpp"
#include "striate/base/time.hpp"
#include "striate/config/settings.hpp"

namespace striate::memory {

/// A landmark's name in fixed memory.
using LandmarkName = FixedText<47>;

/// One look in which a landmark was recognised. Robot frame at the moment of the image.
struct LandmarkSighting {
  std::int64_t landmark = 0;  ///< its number in long-term memory, above 0
  std::string_view name;      ///< cut to a LandmarkName
  TimePoint stamp;            ///< of the image
  double score = 0.0;         ///< 0..1, of the recognition
  double bearing_rad = 0.0;
  double distance_m = 0.0;  ///< not above 0, or not finite: unknown
  /// Of the image: focal length x baseline; Z = this / d. Not above 0: the distance is unknown,
  /// too.
  double disparity_metre_px = 0.0;
};

/// A landmark that the robot has in mind: recognised in this run, recalled, or both.
struct LandmarkInMind {
  std::int64_t landmark = 0;  ///< 0: this entry is not in use
  LandmarkName name;
  int sightings = 0;       ///< looks of this run in which it was recognised; 0: only recalled
  int in_a_row = 0;        ///< of them, those that followed each other closely, up to the newest
  bool confirmed = false;  ///< recognised in enough looks in a row, once
  double score = 0.0;      ///< of the newest look
  TimePoint first_seen;    ///< both meaningless without a sighting
  TimePoint last_seen;
  double bearing_rad = 0.0;  ///< robot frame, now
  bool place_known = false;
  Point2 place;                ///< odometry frame of this run
  double place_sigma_m = 0.0;  ///< standard deviation of the place, larger axis
};

struct LandmarkMemorySettings {
  int confirming_looks = 3;       ///< as in `striate trial --objects`: a place counts after three
  double confirming_s = 3.0;      ///< by hand: the head has come back to it by then
  double look_sigma_share = 0.1;  ///< by hand: three times what 0.35 px make at 2.4 m
};

template <class V>
void visit(V& v, LandmarkMemorySettings& s) {
  using config::Unit;
  v.integer("confirming_looks", s.confirming_looks, {1, 20}, "so many looks confirm a landmark");
  v.number("confirming_time", s.confirming_s, Unit::duration, {0.1, 60},
           "longest time between two looks that count together");
  v.number("look_sigma", s.look_sigma_share, Unit::fraction, {0.001, 1},
           "standard deviation of a place by one look, as a share of its distance");
}

/// The landmarks of short-term memory. Fixed memory: of more than kCapacity, the one not seen for
/// longest makes room. Behaviours and conditions read it; the cycle alone writes.
class LandmarkMemory {
 public:
  static constexpr std::size_t kCapacity = 64;  ///< by hand: 48 recalled, and what is seen
  using Landmarks = std::array<LandmarkInMind, kCapacity>;

  explicit LandmarkMemory(const LandmarkMemorySettings& settings) : settings_(settings) {}

  /// @param at where the robot was when the image was taken, @param now where it is (both in the
  /// odometry frame)
  void see(const LandmarkSighting& sighting, const Pose2& at, const Pose2& now);
  /// Puts a place that long-term memory knows, or that place estimation has bettered. A landmark
  /// that is not in mind yet comes in.
  void recall(std::int64_t landmark, std::string_view name, const Point2& place, double sigma_m);
  /// The robot moved from `before` to `after`: bearings follow.
  void move(const Pose2& before, const Pose2& after);

  /// nullptr where it is not in mind.
  [[nodiscard]] const LandmarkInMind* find(std::string_view name) const;
  [[nodiscard]] const LandmarkInMind* find(std::int64_t landmark) const;
  /// Whether this sighting, once it is taken in, ends a row of looks that is long enough.
  [[nodiscard]] bool confirms(const LandmarkSighting& sighting) const {
    return row_with(sighting) >= settings_.confirming_looks;
  }
  /// Confirmed, and recognised within `window` before `now`.
  [[nodiscard]] bool in_sight(std::string_view name, TimePoint now, Duration window) const;
  [[nodiscard]] const Landmarks& all() const { return landmarks_; }

 private:
  /// How many looks follow each other closely, this one the last.
  [[nodiscard]] int row_with(const LandmarkSighting& sighting) const;
  LandmarkInMind& entry_for(std::int64_t landmark, std::string_view name);

  LandmarkMemorySettings settings_;
  Landmarks landmarks_{};
};

}  // namespace striate::memory
