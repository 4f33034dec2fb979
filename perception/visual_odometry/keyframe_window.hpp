#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <vector>

#include "striate/perception/visual_odometry/rigid_motion.hpp"
#include "striate/perception/visual_odometry/stereo_eyes.hpp"

namespace striate::perception {

/// A point as one keyframe saw it.
struct TrackSight {
  std::int64_t track = 0;
  StereoSight sight;
  double noise_px = 1.0;  ///< ratio to others'
};

struct WindowKeyframe {
  RigidMotion camera_from_world;
  std::vector<TrackSight> sights;  ///< by track, each once
};

/// What the window makes of a point.
struct TrackPlace {
  cv::Vec3d point_m;  ///< in the world
  int sights = 0;
};

/// The last keyframes, whose poses and points are moved together until what was seen fits best
/// (bundle adjustment; the oldest stays where it is). Weights fall with the residual.
class KeyframeWindow {
 public:
  explicit KeyframeWindow(int most) : most_(most) {}

  void clear() { frames_.clear(); }
  /// @param frame its sights sorted by track
  void add(WindowKeyframe frame);
  /// @param noise_px measured, of a sight whose ratio is 1
  void refine(const StereoEyes& eyes, double noise_px);

  [[nodiscard]] const WindowKeyframe& newest() const { return frames_.back(); }
  /// Points of two sights or more, after refine().
  [[nodiscard]] const std::map<std::int64_t, TrackPlace>& places() const { return places_; }

 private:
  int most_;
  std::deque<WindowKeyframe> frames_;
  std::map<std::int64_t, TrackPlace> places_;
};

}  // namespace striate::perception
