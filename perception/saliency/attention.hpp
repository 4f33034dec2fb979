#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "striate/config/settings.hpp"
#include "striate/perception/percept.hpp"

namespace striate::perception {

struct AttentionSettings {
  /// Time constant with which a visited place recovers: some looks elsewhere (ours)
  double recovery_s = 2.0;
  /// Regions whose remaining salience is below are not handed out: half of what regions are cut at
  double least = 0.25;
  /// 5.7 deg, 20 px at width 160: a place this near is the same, and so is what ...
  double same_bearing_rad = 0.10;
  double same_height_px = 8.0;  ///< ... also is this near in the image; half its size if larger
};

template <class V>
void visit(V& v, AttentionSettings& s) {
  using config::Unit;
  v.number("recovery", s.recovery_s, Unit::duration, {0.01, 60.0},
           "time constant with which a visited place becomes interesting again");
  v.number("least", s.least, Unit::fraction, {0.0, 1.0},
           "regions of less remaining salience are not handed out");
  v.number("same_bearing", s.same_bearing_rad, Unit::angle, {0.001, 0.5},
           "bearing within which it is the same place");
  v.number("same_height", s.same_height_px, Unit::pixels, {0.5, 200.0},
           "rows within which it is the same place");
}

/// How places moved in the view since the image before.
struct ViewShift {
  double seconds = 0.0;  ///< that passed; not negative
  double bearing_rad =
      0.0;               ///< what is added to bearings: minus the turn of the base. The regions'
                         ///< bearings are in the robot frame, so the head's pan is in them
  double rows_px = 0.0;  ///< what is added to rows: downwards where the head tilts up
};

/// Hands the proto-objects of a sequence of images out, most salient first, with inhibition of
/// return (the paper's section on saliency): what was handed out is inhibited wholly, moves with
/// the view, and recovers exponentially, so that attention visits everything before it comes back,
/// and comes back to what is most salient first. Ours: that inhibition recovers and moves.
///
/// This is about images: which region recognition looks at next. What the robot knows of salient
/// things beyond the view, for how long its head looked at them, and where to turn next is
/// memory/salient_memory. Neither needs the other.
class Attention {
 public:
  explicit Attention(const AttentionSettings& settings) : settings_(settings) {}

  /// A new image's regions, in any order.
  void look(const std::vector<SalientRegion>& regions, const ViewShift& shift);
  /// The region with the most salience left, which is inhibited thereby; nullptr when none is left
  /// above `least`. Valid until the next look().
  [[nodiscard]] const SalientRegion* next();
  /// 0..1: how much attention avoids that region now.
  [[nodiscard]] double inhibition(const SalientRegion& region) const;

 private:
  struct Visited {
    double bearing_rad = 0.0;
    double row_px = 0.0;
    double inhibition = 0.0;  ///< 0: not in use
  };
  void inhibit(const SalientRegion& region);
  [[nodiscard]] bool same(const Visited& place, const SalientRegion& region) const;

  AttentionSettings settings_;
  std::vector<SalientRegion> regions_;
  std::array<Visited, 32> visited_{};  ///< the most recovered gives way
};

}  // namespace striate::perception
