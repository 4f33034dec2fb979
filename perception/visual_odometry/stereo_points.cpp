#include "striate/perception/visual_odometry/stereo_points.hpp"

#include <algorithm>
#include <cmath>

#include "striate/perception/noise_estimate.hpp"

namespace striate::perception {
namespace {

/// px: nearer to 0 a disparity tells less of the depth than its error (by hand)
constexpr double kLeastDisparity_px = 1.0;
constexpr double kContrastOverNoise = 3.0;  // a patch of noise alone is below it (by hand)

PatchSettings patches_above(double noise) {
  PatchSettings settings;
  settings.least_contrast = std::max(settings.least_contrast, kContrastOverNoise * noise);
  return settings;
}

/// The level of the pyramid on which a keypoint of this scale is looked at.
int level_of_scale(double scale) {
  // A patch of 15 px is to hold two wavelengths or more: 4 px at scale 1 (ours).
  return scale < 2.3 ? 0 : scale < 4.6 ? 1 : 2;
}

}  // namespace

void look_with_both(const StereoView& view, const FeatureSource& source,
                    const VisualOdometrySettings& settings, StereoLook& look) {
  look.eyes = view.eyes;
  look.size = view.left.size();
  look.left_picture.build(view.left);
  look.right_picture.build(view.right);
  source(view.left, settings.most_features, look.left);
  source(view.right, settings.most_features, look.right);
  look.points.clear();
  FeatureMatchSettings matching;
  matching.row_px = settings.row_px;
  const FeatureGrid grid(look.right, look.size);
  look.noise = estimate_noise(view.left);
  const PatchSettings patches = patches_above(look.noise);
  for (const FeaturePair& pair :
       match_eyes(look.left, look.right, grid, look.size, view.eyes.doffs_px, matching)) {
    const Feature& left = look.left.features[pair.from];
    const Feature& right = look.right.features[pair.to];
    const int level = level_of_scale(left.scale);
    const PatchPlace place =
        find_patch(look.left_picture, {left.u_px, left.v_px}, look.right_picture,
                   {right.u_px, right.v_px}, cv::Matx22d::eye(), level, patches);
    if (place.result != PatchPlace::Result::found) continue;
    const double disparity_px = left.u_px - place.u_px + view.eyes.doffs_px;
    if (disparity_px < kLeastDisparity_px) continue;
    if (std::abs(place.v_px - left.v_px) > settings.row_px * left.scale) continue;
    look.points.push_back(
        {pair.from, pair.to, {left.u_px, left.v_px, disparity_px}, level, 0, 1.0});
  }
}

int count_with_contrast(const StereoLook& look) {
  const PatchSettings patches = patches_above(look.noise);
  int count = 0;
  for (const Feature& feature : look.left.features) {
    const cv::Point2d at(feature.u_px, feature.v_px);
    const PatchPlace place = find_patch(look.left_picture, at, look.left_picture, at,
                                        cv::Matx22d::eye(), level_of_scale(feature.scale), patches);
    count += place.result == PatchPlace::Result::found;
  }
  return count;
}

}  // namespace striate::perception
