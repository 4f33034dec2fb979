#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "striate/viewer/messages/common_messages.hpp"

/// tf2_msgs and nav_msgs of ROS 2. Fields in the order and with the names of their public
/// definitions; what a message is for stands there.
namespace striate::viewer::msgs {

struct TFMessage {
  static constexpr const char* kType = "tf2_msgs/TFMessage";
  std::vector<TransformStamped> transforms;
  template <class V>
  void each_field(V& visitor) const {
    visitor("transforms", transforms);
  }
};

struct Odometry {
  static constexpr const char* kType = "nav_msgs/Odometry";
  Header header;
  std::string child_frame_id;
  PoseWithCovariance pose;
  TwistWithCovariance twist;
  template <class V>
  void each_field(V& visitor) const {
    visitor("header", header);
    visitor("child_frame_id", child_frame_id);
    visitor("pose", pose);
    visitor("twist", twist);
  }
};

struct Path {
  static constexpr const char* kType = "nav_msgs/Path";
  Header header;
  std::vector<PoseStamped> poses;
  template <class V>
  void each_field(V& visitor) const {
    visitor("header", header);
    visitor("poses", poses);
  }
};

struct MapMetaData {
  static constexpr const char* kType = "nav_msgs/MapMetaData";
  Time map_load_time;
  float resolution = 0.0F;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  Pose origin;
  template <class V>
  void each_field(V& visitor) const {
    visitor("map_load_time", map_load_time);
    visitor("resolution", resolution);
    visitor("width", width);
    visitor("height", height);
    visitor("origin", origin);
  }
};

struct OccupancyGrid {
  static constexpr const char* kType = "nav_msgs/OccupancyGrid";
  Header header;
  MapMetaData info;
  std::vector<std::int8_t> data;
  template <class V>
  void each_field(V& visitor) const {
    visitor("header", header);
    visitor("info", info);
    visitor("data", data);
  }
};

}  // namespace striate::viewer::msgs
