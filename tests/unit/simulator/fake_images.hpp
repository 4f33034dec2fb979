#pragma once

#include "striate/platform/simulator/image_source.hpp"

namespace striate::simulator {

/// Images whose first pixel tells the frame's number; remembers the scenes it was asked for.
class FakeImages : public ImageSource {
 public:
  StereoFrame image(const SceneState& scene) override {
    scenes.push_back(scene);
    StereoFrame frame;
    frame.left = cv::Mat3b(4, 4, cv::Vec3b(static_cast<unsigned char>(scene.frame % 256), 0, 0));
    frame.right = frame.left.clone();
    frame.focal_px = 200.0;
    frame.baseline_m = 0.12;
    return frame;
  }
  [[nodiscard]] double light_level(Point2 place) const override {
    return place.x_m < 5.0 ? 0.9 : 0.2;
  }
  std::vector<SceneState> scenes;
};

/// A run that a test can steer.
inline World straight_world(double length_m = 20.0) {
  World world;
  world.length_m = length_m;
  world.goal_beyond_m = length_m - 1.0;
  return world;
}

/// The robot stands exactly where the world says that it starts.
inline SimulatorSettings exact_start() {
  SimulatorSettings settings;
  settings.base.start_offset_m = 0.0;
  settings.base.start_turn_rad = 0.0;
  return settings;
}

}  // namespace striate::simulator
