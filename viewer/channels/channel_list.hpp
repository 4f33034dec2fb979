#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/// Under which names, in which form the facts of a cycle are offered: once, for every viewer.
namespace striate::viewer {

/// The channels, in the order of `channel_list()`.
enum class Topic : std::uint8_t {
  tf,
  odom,
  pose,
  trajectory,
  left_image,
  left_info,
  right_image,
  right_info,
  disparity,
  saliency,
  scan,
  sonar,
  map_local,
  map_global,
  obstacles,
  landmarks,
  route,
  cmd_vel,
  battery,
  diagnostics,
  log,
  task,
  wish,
  short_term,
  memory_events,
  cycle,
  seen,
  task_nodes
};

inline constexpr std::size_t kTopics = static_cast<std::size_t>(Topic::task_nodes) + 1;

/// Some of the channels; the place of each is its Topic.
using TopicSet = std::bitset<kTopics>;

struct ChannelInfo {
  Topic topic{};
  std::string name;             ///< "/odom"
  std::string encoding;         ///< "cdr" or "json"
  std::string schema_name;      ///< "nav_msgs/msg/Odometry"
  std::string schema_encoding;  ///< "ros2msg" or "jsonschema"
  std::string schema;
};

/// All channels; the place of each is its Topic.
[[nodiscard]] const std::vector<ChannelInfo>& channel_list();

// Frames of tf, as `striate ros` calls them.
inline constexpr const char* kMapFrame = "map";
inline constexpr const char* kOdometryFrame = "odom";
inline constexpr const char* kBaseFrame = "base_link";
inline constexpr const char* kHeadFrame = "head_link";
inline constexpr const char* kCameraFrame = "stereo_left_optical";

}  // namespace striate::viewer
