#pragma once

#include "striate/platform/interface/robot.hpp"
#include "striate/viewer/channels/cycle_facts.hpp"
#include "striate/viewer/messages/navigation_messages.hpp"
#include "striate/viewer/messages/report_messages.hpp"
#include "striate/viewer/messages/sensor_messages.hpp"

/// What the body felt and what its motors were told, as messages of ROS 2.
namespace striate::viewer {

/// Odometry, head and camera; the map where the robot knows its place on it.
[[nodiscard]] msgs::TFMessage tf_of(const CycleFacts& facts, const RobotDescription& robot);
/// Covariances are zero, which is ROS's word for "unknown".
[[nodiscard]] msgs::Odometry odometry_of(const CycleFacts& facts);
/// The nearest echo of each degree; NaN where the laser said nothing, infinite where nothing is.
[[nodiscard]] msgs::LaserScan scan_of(const RangeScan& scan);
/// Echoes as points of the base's frame, without a height of their own.
[[nodiscard]] msgs::PointCloud2 sonar_of(const RangeScan& scan);
/// A lossless PNG, as recordings hold them. @throws std::runtime_error where it cannot be encoded
void write_image(const cv::Mat3b& image, TimePoint stamp, msgs::CompressedImage& message);
[[nodiscard]] msgs::CameraInfo camera_info_of(const StereoFrame& frame, bool right);
[[nodiscard]] msgs::TwistStamped cmd_vel_of(const CycleFacts& facts);
[[nodiscard]] msgs::BatteryState battery_of(const Senses& senses);

}  // namespace striate::viewer
