#pragma once

#include <vector>

#include "striate/platform/simulator/eye_faults.hpp"
#include "striate/platform/simulator/render/camera_settings.hpp"
#include "striate/platform/simulator/render/noise.hpp"
#include "striate/platform/simulator/render/vec.hpp"
#include "striate/platform/simulator/render/view.hpp"

namespace striate::simulator::render {

/// How the eyes turn while an image is taken, and when. Left and up are positive.
struct EyeMotion {
  double time_s = 0.0;
  double shutter_s = 0.0;
  double turn_rad_s = 0.0;
  double nod_rad_s = 0.0;
};

/// What lens and sensor of one eye do to the light before it is counted: the distortion that was
/// left in, rows that are read one after the other, lamps that flicker, a wrong white, dirt.
class LensFaults {
 public:
  LensFaults(const EyeFaults& faults, const CameraSettings& settings, Eye eye, std::uint64_t seed);

  /// The light as it reaches the pixels; `light` itself where nothing is wrong. Valid until the
  /// next call.
  const std::vector<V4>& apply(const std::vector<V4>& light, const EyeMotion& motion);

 private:
  /// Seconds after the middle of the exposure at which a row is taken.
  [[nodiscard]] double row_time_s(int y) const;
  void bend(const std::vector<V4>& light, const EyeMotion& motion);
  void weigh_rows(const EyeMotion& motion);
  void cover();
  void lay_dirt(std::uint64_t seed);

  EyeFaults faults_;
  int width_ = 0;
  int height_ = 0;
  double focal_px_ = 0.0;
  double flicker_phase_ = 0.0;  ///< of the mains, in turns
  std::vector<float> dirt_;     ///< share of each pixel that is covered; empty: a clean lens
  std::vector<V4> out_;
};

}  // namespace striate::simulator::render
