#pragma once

#include <opencv2/core/mat.hpp>

#include "striate/perception/percept.hpp"
#include "striate/platform/interface/robot.hpp"
#include "striate/platform/interface/senses.hpp"

namespace striate::agent::pictures {

/// The image with what stands in the way: free floor tinted green, each obstacle's pixels tinted
/// red inside a box with its distance (in `unit`).
[[nodiscard]] cv::Mat3b draw_obstacles(const StereoFrame& frame, const perception::Percept& percept,
                                       cv::Size size, const RobotDescription& robot = {},
                                       const char* unit = "m");

/// Salience as heat over the dimmed image, its regions numbered in the order of salience.
[[nodiscard]] cv::Mat3b draw_saliency(const StereoFrame& frame, const perception::Percept& percept,
                                      cv::Size size);

}  // namespace striate::agent::pictures
