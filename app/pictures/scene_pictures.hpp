#pragma once

#include <opencv2/core/mat.hpp>

#include "perception/percept.hpp"
#include "platform/interface/robot.hpp"
#include "platform/interface/senses.hpp"

namespace striate::pictures {

/// The picture with what stands in the way: free floor tinted green, each obstacle's pixels tinted
/// red inside a box with its distance (in `unit`).
[[nodiscard]] cv::Mat3b draw_obstacles(const StereoFrame& frame, const Percept& percept,
                                       cv::Size size, const RobotDescription& robot = {},
                                       const char* unit = "m");

/// Salience as heat over the dimmed picture, its regions numbered in the order of salience.
[[nodiscard]] cv::Mat3b draw_saliency(const StereoFrame& frame, const Percept& percept,
                                      cv::Size size);

}  // namespace striate::pictures
