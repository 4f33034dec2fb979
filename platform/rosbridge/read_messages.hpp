#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>

#include "striate/platform/interface/senses.hpp"
#include "striate/platform/remote/camera_model.hpp"

/// One message of ROS in JSON each, of ROS 1 and of ROS 2, as senses understand it. All throw
/// BadMessage where it cannot be used. Stamps are apart.
namespace striate::rosbridge {

/// ns of the sender's clock; 0 where the message has no header, or no time in it.
[[nodiscard]] std::int64_t stamp_ns_of(const nlohmann::json& message);

/// nav_msgs/Odometry
[[nodiscard]] Odometry odometry_of(const nlohmann::json& message);
/// sensor_msgs/LaserScan, as seen from the axle. @param forward_m place of the laser ahead of it
[[nodiscard]] RangeScan scan_of(const nlohmann::json& message, double forward_m);
/// sensor_msgs/CameraInfo: 'P' of ROS 1 or 'p' of ROS 2
[[nodiscard]] remote::EyeInfo eye_info_of(const nlohmann::json& message);
/// sensor_msgs/Image and sensor_msgs/CompressedImage. @param bits see remote::decode()
[[nodiscard]] cv::Mat3b image_of(const nlohmann::json& message, int& bits);
[[nodiscard]] cv::Mat3b compressed_image_of(const nlohmann::json& message, int& bits);

}  // namespace striate::rosbridge
