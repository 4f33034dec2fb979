#include <cmath>
#include <limits>

#include "striate/base/geometry.hpp"
#include "striate/platform/remote/image_codec.hpp"
#include "striate/platform/ros/messages.hpp"

namespace striate::ros {

cv::Mat3b image_of(const sensor_msgs::Image& message, int& bits) {
  remote::RawImage raw;
  raw.width = message.width;
  raw.height = message.height;
  raw.step = message.step;
  raw.big_endian = message.is_bigendian != 0;
  raw.encoding = message.encoding;
  raw.data = message.data.data();
  raw.size = message.data.size();
  return remote::decode(raw, bits);
}

cv::Mat3b image_of(const sensor_msgs::CompressedImage& message, int& bits) {
  return remote::decode_compressed(message.data.data(), message.data.size(), bits);
}

remote::EyeInfo eye_info_of(const sensor_msgs::CameraInfo& message) {
  remote::EyeInfo info;
  info.width_px = static_cast<int>(message.width);
  for (std::size_t i = 0; i < info.projection.size(); ++i) info.projection[i] = message.P[i];
  return info;
}

bool read(const nav_msgs::Odometry& message, Odometry& odometry) {
  const auto& place = message.pose.pose.position;
  const auto& q = message.pose.pose.orientation;
  const double heading_rad =
      std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
  const double forward_m_s = message.twist.twist.linear.x;
  const double turn_rad_s = message.twist.twist.angular.z;
  if (!std::isfinite(place.x + place.y + heading_rad + forward_m_s + turn_rad_s)) return false;
  odometry.pose = {place.x, place.y, heading_rad};
  odometry.forward_m_s = forward_m_s;
  odometry.turn_rad_s = turn_rad_s;
  return true;
}

void read(const sensor_msgs::LaserScan& message, double forward_m, RangeScan& scan) {
  scan.readings.clear();
  for (std::size_t i = 0; i < message.ranges.size(); ++i) {
    const double range_m = message.ranges[i];
    const double angle_rad = message.angle_min + static_cast<double>(i) * message.angle_increment;
    // REP 117: +inf is nothing within range; -inf, NaN and too near say nothing.
    if (std::isnan(range_m) || range_m < message.range_min) continue;
    if (range_m > message.range_max) {
      scan.readings.push_back({wrap_angle(angle_rad), std::numeric_limits<double>::infinity()});
      continue;
    }
    const double x_m = forward_m + range_m * std::cos(angle_rad);
    const double y_m = range_m * std::sin(angle_rad);
    scan.readings.push_back({std::atan2(y_m, x_m), std::hypot(x_m, y_m)});
  }
}

void read(const sensor_msgs::PointCloud& message, RangeScan& scan) {
  scan.readings.clear();
  for (const auto& point : message.points) {
    const double distance_m =
        std::hypot(static_cast<double>(point.x), static_cast<double>(point.y));
    if (!std::isfinite(distance_m)) continue;
    scan.readings.push_back(
        {std::atan2(static_cast<double>(point.y), static_cast<double>(point.x)), distance_m});
  }
}

MotorCommand command_of(const geometry_msgs::Twist& message) {
  MotorCommand command;
  command.forward_m_s = message.linear.x;
  command.turn_rad_s = message.angular.z;
  return command;
}

}  // namespace striate::ros
