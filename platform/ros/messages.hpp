#pragma once

#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/JointState.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud.h>

#include "striate/platform/interface/motor_command.hpp"
#include "striate/platform/interface/senses.hpp"
#include "striate/platform/remote/camera_model.hpp"

/// Between ROS messages and the interface, both ways. Stamps are the callers' business. ROS's
/// generated headers are C++17: only files of this layer include this one.
namespace striate::ros {

/// @param bits see decode()
/// @throws std::runtime_error for an image that cannot be used
[[nodiscard]] cv::Mat3b image_of(const sensor_msgs::Image& message, int& bits);
[[nodiscard]] cv::Mat3b image_of(const sensor_msgs::CompressedImage& message, int& bits);
[[nodiscard]] remote::EyeInfo eye_info_of(const sensor_msgs::CameraInfo& message);
/// Where a number is none, nothing is returned.
[[nodiscard]] bool read(const nav_msgs::Odometry& message, Odometry& odometry);
/// Echoes as seen from the axle. @param forward_m place of the laser ahead of it
void read(const sensor_msgs::LaserScan& message, double forward_m, RangeScan& scan);
void read(const sensor_msgs::PointCloud& message, RangeScan& scan);
[[nodiscard]] MotorCommand command_of(const geometry_msgs::Twist& message);

void write(const cv::Mat3b& image, sensor_msgs::Image& message);
/// @param right the right eye's, else the left eye's
void write(const StereoFrame& frame, bool right, sensor_msgs::CameraInfo& message);
void write(const Odometry& odometry, nav_msgs::Odometry& message);
/// All round in steps of one degree; the nearest echo of each. No echo asked for: not a number.
void write(const RangeScan& scan, sensor_msgs::LaserScan& message);
void write(const RangeScan& scan, sensor_msgs::PointCloud& message);
[[nodiscard]] geometry_msgs::Twist twist_of(const MotorCommand& command);

}  // namespace striate::ros
