#include "striate/perception/visual_odometry/refined_keyframe.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace striate::perception {
namespace {

/// Disparities of many images are not so much better than one's as chance alone would have it,
/// since patches err alike (by hand)
constexpr double kLeastThenNoise = 0.5;

}  // namespace

void RefinedKeyframe::begin(StereoLook look, const RigidMotion& world_from_camera,
                            std::size_t number) {
  window_.clear();
  look_ = std::move(look);
  world_from_keyframe_ = world_from_camera;
  number_ = number;
  add_to_window();
}

void RefinedKeyframe::replace(StereoLook look, const RigidMotion& look_from_keyframe,
                              std::size_t number, double noise_px) {
  world_from_keyframe_ = straightened(world_from_keyframe_ * inverse(look_from_keyframe));
  look_ = std::move(look);
  number_ = number;
  add_to_window();
  if (keyframes_ < 2 || !(noise_px > 0.0)) return;
  window_.refine(look_.eyes, noise_px);
  world_from_keyframe_ = inverse(window_.newest().camera_from_world);
  take_refined_depths(noise_px);
}

void RefinedKeyframe::add_to_window() {
  WindowKeyframe frame{inverse(world_from_keyframe_), {}};
  for (const StereoPoint& point : look_.points) {
    frame.sights.push_back({point.track, point.sight, std::ldexp(1.0, point.level)});
  }
  std::ranges::sort(frame.sights, {}, &TrackSight::track);
  window_.add(std::move(frame));
}

/// A point that many images have seen is known better than by this one alone.
void RefinedKeyframe::take_refined_depths(double noise_px) {
  constexpr double kFits = 3.0;  // of the noise; farther off the track is of two things
  for (StereoPoint& point : look_.points) {
    const auto place = window_.places().find(point.track);
    if (place == window_.places().end()) continue;
    const cv::Vec3d p = window_.newest().camera_from_world * place->second.point_m;
    if (!(p[2] > 0.0)) continue;
    const double disparity_px = sight_of(look_.eyes, p)[2];
    if (std::abs(disparity_px - point.sight[2]) > kFits * std::ldexp(noise_px, point.level)) {
      continue;
    }
    point.sight[2] = disparity_px;
    point.then_noise = std::max(kLeastThenNoise, 1.0 / std::sqrt(place->second.sights));
  }
}

}  // namespace striate::perception
