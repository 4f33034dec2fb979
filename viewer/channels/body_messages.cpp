#include "striate/viewer/channels/body_messages.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "striate/viewer/channels/channel_list.hpp"
#include "striate/viewer/channels/ros_stamps.hpp"

namespace striate::viewer {
namespace {

constexpr int kScanSteps = 360;  ///< a turn in degrees, whatever the laser's own steps are
/// Nearest that a URG-04LX tells (DMIN of its PP reply, 20 mm)
constexpr float kScanNearest_m = 0.02F;
/// Beyond the reach of both lasers, by hand: nothing is cut off
constexpr float kScanFarthest_m = 30.0F;

msgs::TransformStamped transform_of(TimePoint stamp, const char* from, const char* to,
                                    const Pose2& pose = {}) {
  return {ros_header(stamp, from), to, {{pose.x_m, pose.y_m, 0.0}, ros_heading(pose.heading_rad)}};
}

}  // namespace

msgs::TFMessage tf_of(const CycleFacts& facts, const RobotDescription& robot) {
  const Senses& senses = facts.senses;
  msgs::TFMessage message;
  if (facts.on_map) {
    message.transforms.push_back(transform_of(senses.odometry.stamp, kMapFrame, kOdometryFrame,
                                              facts.on_map->odometry_frame));
  }
  message.transforms.push_back(
      transform_of(senses.odometry.stamp, kOdometryFrame, kBaseFrame, senses.odometry.pose));
  auto head = transform_of(senses.now, kBaseFrame, kHeadFrame);
  head.transform.translation = {robot.camera_forward_m, 0.0, robot.camera_height_m};
  // Pan about z, then tilt about y; y points left, so up is negative.
  const double pan = senses.head.pan_rad / 2.0;
  const double tilt = -senses.head.tilt_rad / 2.0;
  head.transform.rotation = {-std::sin(pan) * std::sin(tilt), std::cos(pan) * std::sin(tilt),
                             std::sin(pan) * std::cos(tilt), std::cos(pan) * std::cos(tilt)};
  message.transforms.push_back(head);
  auto camera = transform_of(senses.now, kHeadFrame, kCameraFrame);
  camera.transform.translation.y = senses.stereo.baseline_m / 2.0;
  // From x ahead, y left to x right, y down, z ahead.
  camera.transform.rotation = {-0.5, 0.5, -0.5, 0.5};
  message.transforms.push_back(camera);
  return message;
}

msgs::Odometry odometry_of(const CycleFacts& facts) {
  const Odometry& felt = facts.senses.odometry;
  msgs::Odometry message;
  message.header = ros_header(felt.stamp, kOdometryFrame);
  message.child_frame_id = kBaseFrame;
  message.pose.pose = ros_pose(felt.pose);
  message.twist.twist.linear.x = felt.forward_m_s;
  message.twist.twist.angular.z = felt.turn_rad_s;
  return message;
}

msgs::LaserScan scan_of(const RangeScan& scan) {
  msgs::LaserScan message;
  message.header = ros_header(scan.stamp, kBaseFrame);
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
  return message;
}

msgs::PointCloud2 sonar_of(const RangeScan& scan) {
  constexpr std::uint8_t kFloat32 = 7;  // PointField.FLOAT32
  msgs::PointCloud2 message;
  message.header = ros_header(scan.stamp, kBaseFrame);
  message.fields = {{"x", 0, kFloat32, 1}, {"y", 4, kFloat32, 1}, {"z", 8, kFloat32, 1}};
  message.point_step = 12;
  message.height = 1;
  message.is_dense = true;
  for (const RangeReading& echo : scan.readings) {
    if (!std::isfinite(echo.distance_m)) continue;
    ByteWriter writer(message.data);
    writer.put(static_cast<float>(echo.distance_m * std::cos(echo.bearing_rad)));
    writer.put(static_cast<float>(echo.distance_m * std::sin(echo.bearing_rad)));
    writer.put(0.0F);
    ++message.width;
  }
  message.row_step = message.point_step * message.width;
  return message;
}

void write_image(const cv::Mat3b& image, TimePoint stamp, msgs::CompressedImage& message) {
  message.header = ros_header(stamp, kCameraFrame);
  message.format = "png";
  if (!cv::imencode(".png", image, message.data, {cv::IMWRITE_PNG_COMPRESSION, 1})) {
    throw std::runtime_error("an image cannot be encoded");
  }
}

msgs::CameraInfo camera_info_of(const StereoFrame& frame, bool right) {
  msgs::CameraInfo message;
  message.header = ros_header(frame.stamp, kCameraFrame);
  message.width = static_cast<std::uint32_t>(frame.left.cols);
  message.height = static_cast<std::uint32_t>(frame.left.rows);
  message.distortion_model = "plumb_bob";
  message.d.assign(5, 0.0);  // rectified
  const double f = frame.focal_px;
  const double u = frame.centre_u_px;
  const double v = frame.centre_v_px;
  message.k = {f, 0, u, 0, f, v, 0, 0, 1};
  message.r = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  message.p = {f, 0, u, right ? -f * frame.baseline_m : 0.0, 0, f, v, 0, 0, 0, 1, 0};
  return message;
}

msgs::TwistStamped cmd_vel_of(const CycleFacts& facts) {
  msgs::TwistStamped message;
  message.header = ros_header(facts.senses.now, kBaseFrame);
  message.twist.linear.x = facts.sent.forward_m_s;
  message.twist.angular.z = facts.sent.turn_rad_s;
  return message;
}

msgs::BatteryState battery_of(const Senses& senses) {
  constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
  msgs::BatteryState message;
  message.header = ros_header(senses.now, kBaseFrame);
  message.voltage = static_cast<float>(senses.battery_v);
  for (float* unknown : {&message.temperature, &message.current, &message.charge, &message.capacity,
                         &message.design_capacity, &message.percentage}) {
    *unknown = kUnknown;
  }
  message.present = true;
  return message;
}

}  // namespace striate::viewer
