#pragma once

#include <array>
#include <cstdint>
#include <string>

/// What other messages are made of: builtin_interfaces, std_msgs and geometry_msgs of ROS 2. Fields
/// in the order and with the names of their public definitions; what a message is for stands there.
namespace striate::viewer::msgs {

struct Time {
  static constexpr const char* kType = "builtin_interfaces/Time";
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
  template <class V>
  void each_field(V& visitor) const {
    visitor("sec", sec);
    visitor("nanosec", nanosec);
  }
};

struct Duration {
  static constexpr const char* kType = "builtin_interfaces/Duration";
  std::int32_t sec = 0;
  std::uint32_t nanosec = 0;
  template <class V>
  void each_field(V& visitor) const {
    visitor("sec", sec);
    visitor("nanosec", nanosec);
  }
};

struct Header {
  static constexpr const char* kType = "std_msgs/Header";
  Time stamp;
  std::string frame_id;
  template <class V>
  void each_field(V& visitor) const {
    visitor("stamp", stamp);
    visitor("frame_id", frame_id);
  }
};

struct ColorRGBA {
  static constexpr const char* kType = "std_msgs/ColorRGBA";
  float r = 0.0F;
  float g = 0.0F;
  float b = 0.0F;
  float a = 0.0F;
  template <class V>
  void each_field(V& visitor) const {
    visitor("r", r);
    visitor("g", g);
    visitor("b", b);
    visitor("a", a);
  }
};

struct Vector3 {
  static constexpr const char* kType = "geometry_msgs/Vector3";
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  template <class V>
  void each_field(V& visitor) const {
    visitor("x", x);
    visitor("y", y);
    visitor("z", z);
  }
};

struct Point {
  static constexpr const char* kType = "geometry_msgs/Point";
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  template <class V>
  void each_field(V& visitor) const {
    visitor("x", x);
    visitor("y", y);
    visitor("z", z);
  }
};

struct Quaternion {
  static constexpr const char* kType = "geometry_msgs/Quaternion";
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double w = 1.0;
  template <class V>
  void each_field(V& visitor) const {
    visitor("x", x);
    visitor("y", y);
    visitor("z", z);
    visitor("w", w);
  }
};

struct Pose {
  static constexpr const char* kType = "geometry_msgs/Pose";
  Point position;
  Quaternion orientation;
  template <class V>
  void each_field(V& visitor) const {
    visitor("position", position);
    visitor("orientation", orientation);
  }
};

struct PoseStamped {
  static constexpr const char* kType = "geometry_msgs/PoseStamped";
  Header header;
  Pose pose;
  template <class V>
  void each_field(V& visitor) const {
    visitor("header", header);
    visitor("pose", pose);
  }
};

struct PoseWithCovariance {
  static constexpr const char* kType = "geometry_msgs/PoseWithCovariance";
  Pose pose;
  std::array<double, 36> covariance{};
  template <class V>
  void each_field(V& visitor) const {
    visitor("pose", pose);
    visitor("covariance", covariance);
  }
};

struct PoseWithCovarianceStamped {
  static constexpr const char* kType = "geometry_msgs/PoseWithCovarianceStamped";
  Header header;
  PoseWithCovariance pose;
  template <class V>
  void each_field(V& visitor) const {
    visitor("header", header);
    visitor("pose", pose);
  }
};

struct Twist {
  static constexpr const char* kType = "geometry_msgs/Twist";
  Vector3 linear;
  Vector3 angular;
  template <class V>
  void each_field(V& visitor) const {
    visitor("linear", linear);
    visitor("angular", angular);
  }
};

struct TwistWithCovariance {
  static constexpr const char* kType = "geometry_msgs/TwistWithCovariance";
  Twist twist;
  std::array<double, 36> covariance{};
  template <class V>
  void each_field(V& visitor) const {
    visitor("twist", twist);
    visitor("covariance", covariance);
  }
};

struct TwistStamped {
  static constexpr const char* kType = "geometry_msgs/TwistStamped";
  Header header;
  Twist twist;
  template <class V>
  void each_field(V& visitor) const {
    visitor("header", header);
    visitor("twist", twist);
  }
};

struct Transform {
  static constexpr const char* kType = "geometry_msgs/Transform";
  Vector3 translation;
  Quaternion rotation;
  template <class V>
  void each_field(V& visitor) const {
    visitor("translation", translation);
    visitor("rotation", rotation);
  }
};

struct TransformStamped {
  static constexpr const char* kType = "geometry_msgs/TransformStamped";
  Header header;
  std::string child_frame_id;
  Transform transform;
  template <class V>
  void each_field(V& visitor) const {
    visitor("header", header);
    visitor("child_frame_id", child_frame_id);
    visitor("transform", transform);
  }
};

}  // namespace striate::viewer::msgs
