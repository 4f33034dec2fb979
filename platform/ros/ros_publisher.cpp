#include "striate/platform/ros/ros_publisher.hpp"

#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/node_handle.h>
#include <stereo_msgs/DisparityImage.h>
#include <tf2_msgs/TFMessage.h>

#include <cmath>
#include <cstring>

#include "striate/base/geometry.hpp"
#include "striate/platform/ros/body_to_ros_time.hpp"
#include "striate/platform/ros/messages.hpp"
#include "striate/platform/ros/node.hpp"

namespace striate::ros {
namespace {

/// Grows with the way, stays finite: 1e308 breaks viewers.
/// m2 and rad2 at the start: 1 cm, 0.6 deg (ours). Grows with the way, stays finite
constexpr double kVarianceAtRest = 1e-4;
/// m2 and rad2 a metre: 4.5 cm and 2.6 deg after the first (ours)
constexpr double kVariancePerMetre = 2e-3;
/// Of what a wheeled base cannot do: rise, roll, pitch.
constexpr double kFixedVariance = 1e-6;

geometry_msgs::TransformStamped transform(const std::string& from, const std::string& to) {
  geometry_msgs::TransformStamped t;
  t.header.frame_id = from;
  t.child_frame_id = to;
  t.transform.rotation.w = 1.0;
  return t;
}

}  // namespace

struct RosPublisher::Parts {
  Parts(const RosSettings& given, const RobotDescription& body, Tells what);
  void advertise_body();
  [[nodiscard]] ::ros::Time at(TimePoint stamp) const {
    ::ros::Time time;
    time.fromNSec(static_cast<std::uint64_t>(time_map.ros_ns(stamp)));
    return time;
  }
  void publish_odometry(const Odometry& odometry);
  void publish_head(const Senses& senses);
  void publish_ranges(const Senses& senses);
  void publish_images(const StereoFrame& frame);

  RosSettings settings;
  RobotDescription description;
  Tells tells;
  BodyToRosTime time_map;
  TimePoint image_stamp{Duration::min()};
  TimePoint laser_stamp{Duration::min()};
  Pose2 last_pose;
  double way_m = 0.0;

  ::ros::NodeHandle node;
  ::ros::Publisher odometry, tf, joints, scan, sonar, disparity, diagnostics;
  ::ros::Publisher left, right, left_info, right_info;
  // Kept, so that a cycle allocates little.
  nav_msgs::Odometry odometry_message;
  tf2_msgs::TFMessage tf_message;
  sensor_msgs::JointState joints_message;
  sensor_msgs::LaserScan scan_message;
  sensor_msgs::PointCloud sonar_message;
  sensor_msgs::Image image_message;
  sensor_msgs::CameraInfo info_message;
  stereo_msgs::DisparityImage disparity_message;
};

RosPublisher::Parts::Parts(const RosSettings& given, const RobotDescription& body, Tells what)
    : settings(given), description(body), tells(what) {
  disparity = node.advertise<stereo_msgs::DisparityImage>(settings.disparity, 2);
  diagnostics = node.advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 2);
  if (tells == Tells::body_and_mind) advertise_body();
}

void RosPublisher::Parts::advertise_body() {
  odometry = node.advertise<nav_msgs::Odometry>(settings.odometry, 5);
  tf = node.advertise<tf2_msgs::TFMessage>("/tf", 5);
  joints = node.advertise<sensor_msgs::JointState>(settings.joints, 5);
  scan = node.advertise<sensor_msgs::LaserScan>(settings.scan, 2);
  sonar = node.advertise<sensor_msgs::PointCloud>(settings.sonar, 2);
  left = node.advertise<sensor_msgs::Image>(settings.left_image, 2);
  right = node.advertise<sensor_msgs::Image>(settings.right_image, 2);
  left_info = node.advertise<sensor_msgs::CameraInfo>(settings.left_info, 2);
  right_info = node.advertise<sensor_msgs::CameraInfo>(settings.right_info, 2);
  joints_message.name = {settings.pan_joint, settings.tilt_joint};
  joints_message.position.resize(2);
  tf_message.transforms = {transform(settings.odometry_frame, settings.base_frame),
                           transform(settings.base_frame, settings.head_frame),
                           transform(settings.head_frame, settings.camera_frame)};
  // From x ahead, y left to x right, y down, z ahead.
  auto& rotation = tf_message.transforms[2].transform.rotation;
  rotation.x = -0.5;
  rotation.y = 0.5;
  rotation.z = -0.5;
  rotation.w = 0.5;
}

void RosPublisher::Parts::publish_odometry(const Odometry& felt) {
  way_m += std::hypot(felt.pose.x_m - last_pose.x_m, felt.pose.y_m - last_pose.y_m);
  last_pose = felt.pose;
  nav_msgs::Odometry& message = odometry_message;
  message.header.stamp = at(felt.stamp);
  message.header.frame_id = settings.odometry_frame;
  message.child_frame_id = settings.base_frame;
  write(felt, message);
  for (std::size_t i = 0; i < 6; ++i) {
    const bool moves = i < 2 || i == 5;
    message.pose.covariance[7 * i] =
        moves ? kVarianceAtRest + kVariancePerMetre * way_m : kFixedVariance;
    message.twist.covariance[7 * i] = moves ? kVarianceAtRest : kFixedVariance;
  }
  odometry.publish(message);
}

void RosPublisher::Parts::publish_head(const Senses& senses) {
  joints_message.header.stamp = at(senses.now);
  joints_message.position[0] = senses.head.pan_rad;
  joints_message.position[1] = senses.head.tilt_rad;
  joints.publish(joints_message);

  auto& base = tf_message.transforms[0];
  base.header.stamp = odometry_message.header.stamp;
  base.transform.translation.x = senses.odometry.pose.x_m;
  base.transform.translation.y = senses.odometry.pose.y_m;
  base.transform.rotation = odometry_message.pose.pose.orientation;
  auto& head = tf_message.transforms[1];
  head.header.stamp = at(senses.now);
  head.transform.translation.x = description.camera_forward_m;
  head.transform.translation.z = description.camera_height_m;
  // Pan about z, then tilt about y; y points left, so up is negative.
  const double pan = senses.head.pan_rad / 2.0;
  const double tilt = -senses.head.tilt_rad / 2.0;
  head.transform.rotation.x = -std::sin(pan) * std::sin(tilt);
  head.transform.rotation.y = std::cos(pan) * std::sin(tilt);
  head.transform.rotation.z = std::sin(pan) * std::cos(tilt);
  head.transform.rotation.w = std::cos(pan) * std::cos(tilt);
  auto& camera = tf_message.transforms[2];
  camera.header.stamp = at(senses.now);
  camera.transform.translation.y = senses.stereo.baseline_m / 2.0;
  tf.publish(tf_message);
}

void RosPublisher::Parts::publish_ranges(const Senses& senses) {
  if (!senses.laser.readings.empty() && senses.laser.stamp != laser_stamp) {
    laser_stamp = senses.laser.stamp;
    scan_message.header.stamp = at(senses.laser.stamp);
    scan_message.header.frame_id = settings.base_frame;
    write(senses.laser, scan_message);
    scan.publish(scan_message);
  }
  sonar_message.header.stamp = at(senses.sonar.stamp);
  sonar_message.header.frame_id = settings.base_frame;
  write(senses.sonar, sonar_message);
  sonar.publish(sonar_message);
}

void RosPublisher::Parts::publish_images(const StereoFrame& frame) {
  if (frame.left.empty() || frame.stamp == image_stamp) return;
  image_stamp = frame.stamp;
  image_message.header.stamp = info_message.header.stamp = at(frame.stamp);
  image_message.header.frame_id = info_message.header.frame_id = settings.camera_frame;
  write(frame, false, info_message);
  left_info.publish(info_message);
  write(frame.left, image_message);
  left.publish(image_message);
  if (frame.right.empty()) return;
  write(frame, true, info_message);
  right_info.publish(info_message);
  write(frame.right, image_message);
  right.publish(image_message);
}

RosPublisher::RosPublisher(const RosSettings& settings, const RobotDescription& description,
                           Tells tells) {
  join_ros("striate");
  parts_ = std::make_unique<Parts>(settings, description, tells);
}

RosPublisher::~RosPublisher() = default;

void RosPublisher::publish(const Senses& senses) {
  Parts& p = *parts_;
  p.time_map.tie(senses.now, static_cast<std::int64_t>(::ros::Time::now().toNSec()));
  if (p.tells == Tells::mind) return;
  p.publish_odometry(senses.odometry);
  p.publish_head(senses);
  p.publish_ranges(senses);
  p.publish_images(senses.stereo);
}

void RosPublisher::publish(const Disparity& disparity, TimePoint stamp) {
  Parts& p = *parts_;
  stereo_msgs::DisparityImage& message = p.disparity_message;
  const cv::Mat1f& map = disparity.disparity_px;
  message.header.stamp = message.image.header.stamp = p.at(stamp);
  message.header.frame_id = message.image.header.frame_id = p.settings.camera_frame;
  message.f = static_cast<float>(disparity.focal_px);
  message.T = static_cast<float>(disparity.baseline_m);
  message.min_disparity = 0.0F;
  message.max_disparity = static_cast<float>(disparity.most_px);
  message.image.width = static_cast<std::uint32_t>(map.cols);
  message.image.height = static_cast<std::uint32_t>(map.rows);
  message.image.step = message.image.width * sizeof(float);
  message.valid_window.width = message.image.width;
  message.valid_window.height = message.image.height;
  message.image.encoding = "32FC1";
  message.image.data.resize(map.total() * sizeof(float));
  for (int v = 0; v < map.rows; ++v) {
    for (int u = 0; u < map.cols; ++u) {
      // Below min_disparity is how stereo_msgs says that nothing is known.
      const float value = std::isfinite(map(v, u)) ? map(v, u) : -1.0F;
      std::memcpy(&message.image.data[(static_cast<std::size_t>(v) * map.cols + u) * sizeof(float)],
                  &value, sizeof(float));
    }
  }
  p.disparity.publish(message);
}

void RosPublisher::publish(const Health& health) {
  diagnostic_msgs::DiagnosticArray message;
  message.header.stamp = ::ros::Time::now();
  message.status.resize(1);
  auto& status = message.status.front();
  status.name = "striate: mission";
  status.hardware_id = "striate";
  status.level = static_cast<std::uint8_t>(health.ok ? diagnostic_msgs::DiagnosticStatus::OK
                                                     : diagnostic_msgs::DiagnosticStatus::WARN);
  status.message = health.summary;
  for (const auto& [name, value] : health.details) {
    status.values.emplace_back();
    status.values.back().key = name;
    status.values.back().value = value;
  }
  parts_->diagnostics.publish(message);
}

}  // namespace striate::ros
