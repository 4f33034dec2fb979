#pragma once

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "striate/platform/simulator/render/renderer.hpp"

/// Small worlds for the renderer's tests.
namespace striate::simulator::test {

/// A bright corridor of 12 m, 2.4 m wide, with nothing in it.
inline World bright_corridor() {
  World world;
  world.name = "test";
  world.length_m = 12.0;
  world.lights = {{0.0, 12.0, 4.0, 1.0}};
  return world;
}

/// Small and clean unless a test is about the camera's faults.
inline CameraSettings clean_camera(int width_px = 160) {
  CameraSettings camera;
  camera.width_px = width_px;
  camera.noise = false;
  camera.flicker = 0.0;
  camera.gain_mismatch = 0.0;
  camera.rectification_px = 0.0;
  return camera;
}

inline SceneState standing_at(double x_m, double y_m, double heading_deg = 0.0) {
  SceneState state;
  state.robot = {x_m, y_m, radians(heading_deg)};
  return state;
}

inline double mean_of(const cv::Mat3b& image, const cv::Rect& where) {
  const cv::Scalar mean = cv::mean(image(where));
  return (mean[0] + mean[1] + mean[2]) / 3.0;
}

inline bool same(const cv::Mat3b& a, const cv::Mat3b& b) {
  return cv::norm(a, b, cv::NORM_INF) == 0.0;
}

}  // namespace striate::simulator::test
