#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "striate/viewer/messages/common_messages.hpp"
#include "striate/viewer/messages/sensor_messages.hpp"

/// visualization_msgs, diagnostic_msgs and rcl_interfaces of ROS 2. Fields in the order and with
/// the names of their public definitions; what a message is for stands there.
namespace striate::viewer::msgs {

struct UVCoordinate {
  static constexpr const char* kType = "visualization_msgs/UVCoordinate";
  float u = 0.0F;
  float v = 0.0F;
  template <class V>
  void each_field(V& visitor) const {
    visitor("u", u);
    visitor("v", v);
  }
};

struct MeshFile {
  static constexpr const char* kType = "visualization_msgs/MeshFile";
  std::string filename;
  std::vector<std::uint8_t> data;
  template <class V>
  void each_field(V& visitor) const {
    visitor("filename", filename);
    visitor("data", data);
  }
};

struct Marker {
  static constexpr const char* kType = "visualization_msgs/Marker";
  Header header;
  std::string ns;
  std::int32_t id = 0;
  std::int32_t type = 0;
  std::int32_t action = 0;
  Pose pose;
  Vector3 scale;
  ColorRGBA color;
  Duration lifetime;
  bool frame_locked = false;
  std::vector<Point> points;
  std::vector<ColorRGBA> colors;
  std::string texture_resource;
  CompressedImage texture;
  std::vector<UVCoordinate> uv_coordinates;
  std::string text;
  std::string mesh_resource;
  MeshFile mesh_file;
  bool mesh_use_embedded_materials = false;
  template <class V>
  void each_field(V& visitor) const {
    visitor("header", header);
    visitor("ns", ns);
    visitor("id", id);
    visitor("type", type);
    visitor("action", action);
    visitor("pose", pose);
    visitor("scale", scale);
    visitor("color", color);
    visitor("lifetime", lifetime);
    visitor("frame_locked", frame_locked);
    visitor("points", points);
    visitor("colors", colors);
    visitor("texture_resource", texture_resource);
    visitor("texture", texture);
    visitor("uv_coordinates", uv_coordinates);
    visitor("text", text);
    visitor("mesh_resource", mesh_resource);
    visitor("mesh_file", mesh_file);
    visitor("mesh_use_embedded_materials", mesh_use_embedded_materials);
  }
};

struct MarkerArray {
  static constexpr const char* kType = "visualization_msgs/MarkerArray";
  std::vector<Marker> markers;
  template <class V>
  void each_field(V& visitor) const {
    visitor("markers", markers);
  }
};

struct KeyValue {
  static constexpr const char* kType = "diagnostic_msgs/KeyValue";
  std::string key;
  std::string value;
  template <class V>
  void each_field(V& visitor) const {
    visitor("key", key);
    visitor("value", value);
  }
};

struct DiagnosticStatus {
  static constexpr const char* kType = "diagnostic_msgs/DiagnosticStatus";
  std::byte level{};
  std::string name;
  std::string message;
  std::string hardware_id;
  std::vector<KeyValue> values;
  template <class V>
  void each_field(V& visitor) const {
    visitor("level", level);
    visitor("name", name);
    visitor("message", message);
    visitor("hardware_id", hardware_id);
    visitor("values", values);
  }
};

struct DiagnosticArray {
  static constexpr const char* kType = "diagnostic_msgs/DiagnosticArray";
  Header header;
  std::vector<DiagnosticStatus> status;
  template <class V>
  void each_field(V& visitor) const {
    visitor("header", header);
    visitor("status", status);
  }
};

struct Log {
  static constexpr const char* kType = "rcl_interfaces/Log";
  Time stamp;
  std::uint8_t level = 0;
  std::string name;
  std::string msg;
  std::string file;
  std::string function;
  std::uint32_t line = 0;
  template <class V>
  void each_field(V& visitor) const {
    visitor("stamp", stamp);
    visitor("level", level);
    visitor("name", name);
    visitor("msg", msg);
    visitor("file", file);
    visitor("function", function);
    visitor("line", line);
  }
};

}  // namespace striate::viewer::msgs
