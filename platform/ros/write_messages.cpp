#include <sensor_msgs/image_encodings.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "striate/base/geometry.hpp"
#include "striate/platform/ros/messages.hpp"

namespace striate::ros {
namespace {

constexpr int kScanSteps = 360;  // a turn in degrees, whatever the body's own steps are
/// Nearest that a URG-04LX tells (DMIN of its PP reply, 20 mm)
constexpr float kScanNearest_m = 0.02F;
/// Beyond the reach of both lasers: nothing is cut off (ours)
constexpr float kScanFarthest_m = 30.0F;

}  // namespace

void write(const cv::Mat3b& image, sensor_msgs::Image& message) {
  message.width = static_cast<std::uint32_t>(image.cols);
  message.height = static_cast<std::uint32_t>(image.rows);
  message.step = message.width * 3;
  message.encoding = sensor_msgs::image_encodings::BGR8;
  message.is_bigendian = 0;
  message.data.resize(static_cast<std::size_t>(message.step) * message.height);
  for (int v = 0; v < image.rows; ++v) {
    std::memcpy(message.data.data() + static_cast<std::size_t>(v) * message.step, image.ptr(v),
                message.step);
  }
}

void write(const StereoFrame& frame, bool right, sensor_msgs::CameraInfo& message) {
  message.width = static_cast<std::uint32_t>(frame.left.cols);
  message.height = static_cast<std::uint32_t>(frame.left.rows);
  message.distortion_model = "plumb_bob";
  message.D.assign(5, 0.0);
  const double f = frame.focal_px;
  const double u = frame.centre_u_px;
  const double v = frame.centre_v_px;
  message.K = {f, 0, u, 0, f, v, 0, 0, 1};
  message.R = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  message.P = {f, 0, u, right ? -f * frame.baseline_m : 0.0, 0, f, v, 0, 0, 0, 1, 0};
}

void write(const Odometry& odometry, nav_msgs::Odometry& message) {
  message.pose.pose.position.x = odometry.pose.x_m;
  message.pose.pose.position.y = odometry.pose.y_m;
  message.pose.pose.orientation.z = std::sin(odometry.pose.heading_rad / 2.0);
  message.pose.pose.orientation.w = std::cos(odometry.pose.heading_rad / 2.0);
  message.twist.twist.linear.x = odometry.forward_m_s;
  message.twist.twist.angular.z = odometry.turn_rad_s;
}

void write(const RangeScan& scan, sensor_msgs::LaserScan& message) {
  message.angle_increment = static_cast<float>(2.0 * kPi / kScanSteps);
  message.angle_min = static_cast<float>(-kPi);
  message.angle_max = message.angle_min + message.angle_increment * (kScanSteps - 1);
  message.range_min = kScanNearest_m;
  message.range_max = kScanFarthest_m;
  message.ranges.assign(kScanSteps, std::numeric_limits<float>::quiet_NaN());
  for (const RangeReading& echo : scan.readings) {
    const double turn = (wrap_angle(echo.bearing_rad) + kPi) / (2.0 * kPi);
    const auto step = static_cast<std::size_t>(std::lround(turn * kScanSteps)) % kScanSteps;
    float& range_m = message.ranges[step];
    // fmin takes the number where the other is none.
    range_m = std::fmin(range_m, static_cast<float>(echo.distance_m));
  }
}

void write(const RangeScan& scan, sensor_msgs::PointCloud& message) {
  message.points.clear();
  for (const RangeReading& echo : scan.readings) {
    if (!std::isfinite(echo.distance_m)) continue;
    geometry_msgs::Point32 point;
    point.x = static_cast<float>(echo.distance_m * std::cos(echo.bearing_rad));
    point.y = static_cast<float>(echo.distance_m * std::sin(echo.bearing_rad));
    message.points.push_back(point);
  }
}

geometry_msgs::Twist twist_of(const MotorCommand& command) {
  geometry_msgs::Twist twist;
  twist.linear.x = command.forward_m_s;
  twist.angular.z = command.turn_rad_s;
  return twist;
}

}  // namespace striate::ros
