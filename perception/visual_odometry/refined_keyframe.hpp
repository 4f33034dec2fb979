#pragma once

#include "striate/perception/visual_odometry/keyframe_window.hpp"
#include "striate/perception/visual_odometry/stereo_points.hpp"

namespace striate::perception {

/// The keyframe that views are compared with and where it is, which those before it help to tell.
class RefinedKeyframe {
 public:
  /// @param keyframes that are refined together; 1: none
  explicit RefinedKeyframe(int keyframes) : keyframes_(keyframes), window_(keyframes) {}

  /// Forgets those before it. @param number of the view
  void begin(StereoLook look, const RigidMotion& world_from_camera, std::size_t number);

  /// A later view takes its place, and the last keyframes are refined together.
  /// @param look its points carry the tracks of this one's
  /// @param noise_px measured, of a fine keypoint's place; 0: not known, nothing is refined
  void replace(StereoLook look, const RigidMotion& look_from_keyframe, std::size_t number,
               double noise_px);

  [[nodiscard]] const StereoLook& look() const { return look_; }
  [[nodiscard]] const RigidMotion& world_from_keyframe() const { return world_from_keyframe_; }
  [[nodiscard]] std::size_t number() const { return number_; }

 private:
  void add_to_window();
  void take_refined_depths(double noise_px);

  int keyframes_;
  KeyframeWindow window_;
  StereoLook look_;
  RigidMotion world_from_keyframe_;
  std::size_t number_ = 0;
};

}  // namespace striate::perception
