#pragma once

#include <string>

#include "striate/platform/interface/robot.hpp"

/// What a body may say at all. Numbers come over lines, out of files and from other people's
/// plugins: what enters is looked at once, where it enters, and refused with a reason. Behind that
/// everything counts on it. Each function returns why not, in plain words; empty: it may be.
namespace striate {

/// The image pair and the numbers of its camera. One without an image says nothing, and may.
[[nodiscard]] std::string why_implausible(const StereoFrame& frame);

/// Everything else that is felt: times, odometry, ranges, head, battery.
[[nodiscard]] std::string why_implausible(const Senses& senses);

/// A body's shape, limits and the mount of its camera.
[[nodiscard]] std::string why_implausible(const RobotDescription& robot);

/// Whether the frame is one of a camera with this view and baseline: within a factor of
/// kOtherCamera, which no calibration reaches. `baseline_m` of 0: it is not known.
[[nodiscard]] std::string why_of_another_camera(const StereoFrame& frame, double view_rad,
                                                double baseline_m);

}  // namespace striate
