#pragma once

#include "striate/perception/low_things/floor_band.hpp"
#include "striate/perception/low_things/low_thing_settings.hpp"
#include "striate/perception/obstacles/obstacles.hpp"
#include "striate/perception/stereo/stereo_matcher.hpp"
#include "striate/platform/interface/senses.hpp"

namespace striate::perception {

/// Low things rise by about one pixel of the working image, so they are looked for in an image that
/// is wider by this factor (ours).
inline constexpr int kFinerSize = 2;

/// Low things on the near floor: a parcel, a plank, a step. At the working size they rise above the
/// floor line by about a pixel. Here the near floor is matched again at twice that size, against
/// the floor line itself (FloorBand), and judged by the same rules as everything else.
class LowThingFinder {
 public:
  LowThingFinder(const LowThingSettings& settings, const StereoSettings& stereo,
                 const RobotDescription& robot);

  /// The disparities of the near floor; without rows where no near floor is in view, or the images
  /// are too small for a finer size. Its rows are those from the band's first row on.
  /// @param left the whole left image, grey. @param coarse at the working size
  [[nodiscard]] DisparityMap measure(const StereoFrame& frame, const cv::Mat1b& left,
                                     const DisparityMap& coarse);

  /// What `measure` shows to stand; its columns are those of the finer size.
  [[nodiscard]] ObstacleView judge(const DisparityMap& fine, const HeadPose& head) const;

 private:
  [[nodiscard]] int first_row_of(const ViewGeometry& geometry, int rows) const;
  void trust_only_what_agrees(const FloorBand& band, const DisparityMap& coarse,
                              DisparityMap& fine) const;

  LowThingSettings settings_;
  RobotDescription robot_;
  int width_px_;  ///< of the finer size
  StereoMatcher matcher_;
};

/// Puts low things into the columns and obstacles of the working size: where they stand nearer than
/// what was seen there.
void add_low_things(const ObstacleView& low, ObstacleView& view);

}  // namespace striate::perception
