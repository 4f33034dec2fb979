#include "striate/viewer/channels/mind_messages.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "striate/viewer/channels/channel_list.hpp"
#include "striate/viewer/channels/ros_stamps.hpp"

namespace striate::viewer {
namespace {

// visualization_msgs/Marker's own numbers
enum MarkerType : std::int32_t { kCube = 1, kSphere = 2, kLineList = 5, kText = 9 };
constexpr std::int32_t kDeleteAll = 3;

// How the markers look, all by hand: to be told apart in a viewer, nothing is decided by it.
constexpr double kThin_m = 0.05;     ///< depth of a box of which only the front is seen
constexpr double kLetters_m = 0.15;  ///< height of a name
constexpr double kLeastBall_m = 0.1;
const msgs::ColorRGBA kOrange{0.9F, 0.5F, 0.1F, 0.8F};
const msgs::ColorRGBA kPurple{0.7F, 0.1F, 0.9F, 0.8F};
const msgs::ColorRGBA kGreen{0.1F, 0.7F, 0.3F, 0.8F};
const msgs::ColorRGBA kGrey{0.6F, 0.6F, 0.6F, 0.8F};

/// An array that first removes what was shown before.
msgs::MarkerArray fresh_markers(const msgs::Header& header) {
  msgs::MarkerArray message;
  message.markers.resize(1);
  message.markers.front().header = header;
  message.markers.front().action = kDeleteAll;
  return message;
}

msgs::Marker& add_marker(msgs::MarkerArray& message, const char* name, MarkerType type,
                         const msgs::ColorRGBA& color) {
  msgs::Marker marker;
  marker.header = message.markers.front().header;
  marker.ns = name;
  marker.id = static_cast<std::int32_t>(message.markers.size());
  marker.type = type;
  marker.color = color;
  return message.markers.emplace_back(std::move(marker));
}

void place_box(msgs::Marker& marker, double bearing_rad, double distance_m, double width_m,
               double height_m) {
  marker.pose.position = {distance_m * std::cos(bearing_rad), distance_m * std::sin(bearing_rad),
                          height_m / 2.0};
  marker.pose.orientation = ros_heading(bearing_rad);
  marker.scale = {kThin_m, std::max(width_m, kThin_m), std::max(height_m, kThin_m)};
}

void start_image(msgs::Image& image, const msgs::Header& header, const cv::Mat& of,
                 const char* encoding) {
  image.header = header;
  image.width = static_cast<std::uint32_t>(of.cols);
  image.height = static_cast<std::uint32_t>(of.rows);
  image.encoding = encoding;
}

}  // namespace

void write_disparity(const CycleFacts& facts, msgs::DisparityImage& message) {
  const cv::Mat1f& map = facts.disparity.disparity_px;
  message.header = ros_header(facts.percept_stamp, kCameraFrame);
  start_image(message.image, message.header, map, "32FC1");
  message.image.step = message.image.width * sizeof(float);
  message.f = static_cast<float>(facts.disparity.focal_px);
  message.t = static_cast<float>(facts.disparity.baseline_m);
  message.valid_window = {0, 0, message.image.height, message.image.width, false};
  message.min_disparity = 0.0F;
  message.max_disparity = 0.0F;
  message.image.data.resize(map.total() * sizeof(float));
  std::uint8_t* to = message.image.data.data();
  for (int v = 0; v < map.rows; ++v) {
    for (int u = 0; u < map.cols; ++u, to += sizeof(float)) {
      const float value = std::isfinite(map(v, u)) ? map(v, u) : -1.0F;
      message.max_disparity = std::max(message.max_disparity, value);
      std::memcpy(to, &value, sizeof(float));
    }
  }
}

void write_saliency(const CycleFacts& facts, msgs::Image& message) {
  start_image(message, ros_header(facts.percept_stamp, kCameraFrame), facts.salience, "mono8");
  message.step = message.width;
  cv::Mat1b grey;
  facts.salience.convertTo(grey, CV_8U, 255.0);
  message.data.assign(grey.begin(), grey.end());
}

msgs::MarkerArray obstacles_of(const CycleFacts& facts) {
  msgs::MarkerArray message = fresh_markers(ros_header(facts.percept_stamp, kBaseFrame));
  for (const perception::Obstacle& one : facts.obstacles) {
    msgs::Marker& marker = add_marker(message, "obstacles", kCube, kOrange);
    place_box(marker, one.bearing_rad, one.distance_m, one.width_m, one.height_m);
  }
  for (const perception::MovingThing& one : facts.moving) {
    constexpr double kPerson_m = 1.7;  // how high is not known; by hand, for a person to look at
    msgs::Marker& marker = add_marker(message, "moving", kCube, kPurple);
    place_box(marker, one.bearing_rad, one.distance_m, one.width_m, kPerson_m);
  }
  return message;
}

void write_grid(const FloorGrid& grid, const msgs::Header& header, msgs::OccupancyGrid& message) {
  message.header = header;
  message.info.map_load_time = header.stamp;
  message.info.resolution = static_cast<float>(grid.cell_m);
  message.info.width = static_cast<std::uint32_t>(grid.columns);
  message.info.height = static_cast<std::uint32_t>(grid.rows);
  message.info.origin.position = {grid.corner.x_m, grid.corner.y_m, 0.0};
  message.data = grid.percent;
}

msgs::Path trajectory_of(const CycleFacts& facts) {
  msgs::Path message;
  message.header = ros_header(facts.senses.now, kOdometryFrame);
  for (const Point2& point : facts.slow.trajectory) {
    message.poses.push_back({message.header, {{point.x_m, point.y_m, 0.0}, {}}});
  }
  return message;
}

msgs::MarkerArray landmarks_of(const CycleFacts& facts) {
  msgs::MarkerArray message = fresh_markers(ros_header(facts.senses.now, kOdometryFrame));
  for (const NamedPlace& one : facts.slow.landmarks) {
    const msgs::Point place{one.place.x_m, one.place.y_m, 0.0};
    const double wide_m = std::max(2.0 * one.sigma_m, kLeastBall_m);
    msgs::Marker& ball = add_marker(message, "landmarks", kSphere, one.seen ? kGreen : kGrey);
    ball.pose.position = place;
    ball.scale = {wide_m, wide_m, kLeastBall_m};
    msgs::Marker& name = add_marker(message, "names", kText, one.seen ? kGreen : kGrey);
    name.pose.position = place;
    name.pose.position.z = 2.0 * kLetters_m;
    name.scale.z = kLetters_m;
    name.text = one.name;
  }
  return message;
}

msgs::MarkerArray routes_of(const CycleFacts& facts) {
  msgs::MarkerArray message = fresh_markers(ros_header(facts.senses.now, kMapFrame));
  if (facts.slow.routes.empty()) return message;
  msgs::Marker& lines = add_marker(message, "routes", kLineList, kGrey);
  lines.scale.x = kThin_m;
  for (const auto& [from, to] : facts.slow.routes) {
    lines.points.push_back({from.x_m, from.y_m, 0.0});
    lines.points.push_back({to.x_m, to.y_m, 0.0});
  }
  return message;
}

msgs::PoseWithCovarianceStamped pose_of(const CycleFacts& facts) {
  msgs::PoseWithCovarianceStamped message;
  message.header = ros_header(facts.senses.odometry.stamp, kMapFrame);
  message.pose.pose = ros_pose(facts.on_map->pose);
  // Rows and columns of ROS: x, y, z, roll, pitch, yaw; ours: x, y, heading.
  constexpr std::array<std::size_t, 3> kOurs{0, 1, 5};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      message.pose.covariance[6 * kOurs[row] + kOurs[column]] =
          facts.on_map->covariance[3 * row + column];
    }
  }
  return message;
}

}  // namespace striate::viewer
