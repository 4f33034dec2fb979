#pragma once

#include <array>
#include <cstddef>

#include "striate/config/settings.hpp"
#include "striate/perception/percept.hpp"

namespace striate::memory {

/// One remembered salient region.
struct RememberedRegion {
  bool used = false;
  int id = 0;                                  ///< never reused in a run
  double bearing_rad = 0.0;                    ///< robot frame, now
  double distance_m = perception::kNothing_m;  ///< kNothing_m: unknown
  double size_rad = 0.0;                       ///< its width as an angle
  double salience = 0.0;
  int hits = 0;             ///< looks in which it was seen
  double activation = 0.0;  ///< grows with each hit by its salience, decays with time
  TimePoint first_seen;
  TimePoint last_seen;
  TimePoint inhibited_until;  ///< attention does not return before
};

///
/// By hand (README.md, "Where the numbers come from"); the tests are SalientMemory.*.
struct SalientSettings {
  double match_rad = 0.12;  ///< a sixth of the 43 degree view
  double decay_s = 3.0;
  double expires_s = 8.0;      ///< longer than a look round (4 s) takes to come back
  double inhibition_s = 6.0;   ///< shorter than a region is kept: it is looked at again
  double attended_rad = 0.10;  ///< twice what the head counts as there (0.05 rad)
  double attended_s = 0.5;     ///< five images
};

template <class V>
void visit(V& v, SalientSettings& s) {
  using config::Unit;
  v.number("match", s.match_rad, Unit::angle, {0.01, 0.5}, "bearing within which it is the same");
  v.number("decay", s.decay_s, Unit::duration, {0.1, 60}, "time constant of activation");
  v.number("expires", s.expires_s, Unit::duration, {0.5, 120}, "unmatched for so long: forgotten");
  v.number("inhibition", s.inhibition_s, Unit::duration, {0, 60},
           "attention does not return to an attended region before");
  v.number("attended", s.attended_rad, Unit::angle, {0.01, 0.5},
           "a region this near the line of sight is being looked at");
  v.number("attended_for", s.attended_s, Unit::duration, {0, 10},
           "looked at for so long: attended");
}

/// The seven salient regions of short-term memory (seven: the span of human short-term memory).
/// The least active is evicted, an unmatched one expires, and one that the head has looked at for
/// a while is inhibited, so that attention moves on.
class SalientMemory {
 public:
  static constexpr std::size_t kCapacity = 7;  ///< the span of human short-term memory, as above
  using Regions = std::array<RememberedRegion, kCapacity>;

  explicit SalientMemory(const SalientSettings& settings) : settings_(settings) {}

  /// The robot moved from `before` to `after`: bearings and distances follow.
  void move(const Pose2& before, const Pose2& after);
  /// Regions of one image, already in the robot frame of now. `radians_per_px` turns widths.
  void see(const std::vector<perception::SalientRegion>& seen, double radians_per_px,
           TimePoint stamp);
  /// Time passes and the head looks along `gaze_rad` (robot frame).
  void attend(double gaze_rad, TimePoint now, Duration step);

  [[nodiscard]] const Regions& regions() const { return regions_; }
  /// The most active region that attention may go to; nullptr if there is none.
  [[nodiscard]] const RememberedRegion* most_interesting(TimePoint now) const;

 private:
  [[nodiscard]] RememberedRegion* find(const perception::SalientRegion& seen);
  [[nodiscard]] RememberedRegion& place_for_new();

  SalientSettings settings_;
  Regions regions_{};
  std::array<double, kCapacity> looked_at_s_{};
  int next_id_ = 1;
};

}  // namespace striate::memory
