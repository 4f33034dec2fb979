#pragma once

#include <opencv2/core/matx.hpp>
#include <optional>
#include <vector>

#include "striate/evaluation/odometry/pose_pairs.hpp"

/// The truth of somebody's body, as that of the camera that the estimate is of.
namespace striate::evaluation {

/// Where the camera is on the body of the truth: takes a point of the camera to the body's frame.
using BodyFromSensor = std::optional<cv::Matx44d>;

/// The truth of the body becomes that of a camera on it; nothing: it is the camera's already.
void move_to_sensor(const BodyFromSensor& body_from_sensor, std::vector<PosePair>& pairs);

/// Files are about in which the rotation is that of the world in the camera, whatever they say.
/// @param scale the estimate's is unknown
/// @return whether turns and ways of the estimate both fit the truth clearly better that way
[[nodiscard]] bool rotations_are_inverted(const std::vector<PosePair>& pairs,
                                          const BodyFromSensor& body_from_sensor, bool scale);

/// Inverts the rotations of the truth where they are, and says so in the remarks. Before
/// move_to_sensor(), whose way goes along the axes of the body.
void invert_truth_if_it_is(const BodyFromSensor& body_from_sensor, bool scale, PairedPoses& poses);

}  // namespace striate::evaluation
