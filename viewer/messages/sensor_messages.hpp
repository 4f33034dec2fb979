#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "striate/viewer/messages/common_messages.hpp"

/// sensor_msgs and stereo_msgs of ROS 2. Fields in the order and with the names of their public
/// definitions; what a message is for stands there.
namespace striate::viewer::msgs {

struct CompressedImage {
  static constexpr const char* kType = "sensor_msgs/CompressedImage";
  Header header;
  std::string format;
  std::vector<std::uint8_t> data;
  template <class V>
  void each_field(V& visitor) const {
    visitor("header", header);
    visitor("format", format);
    visitor("data", data);
  }
};

struct Image {
  static constexpr const char* kType = "sensor_msgs/Image";
  Header header;
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::string encoding;
  std::uint8_t is_bigendian = 0;
  std::uint32_t step = 0;
  std::vector<std::uint8_t> data;
  template <class V>
  void each_field(V& visitor) const {
    visitor("header", header);
    visitor("height", height);
    visitor("width", width);
    visitor("encoding", encoding);
    visitor("is_bigendian", is_bigendian);
    visitor("step", step);
    visitor("data", data);
  }
};

struct RegionOfInterest {
  static constexpr const char* kType = "sensor_msgs/RegionOfInterest";
  std::uint32_t x_offset = 0;
  std::uint32_t y_offset = 0;
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  bool do_rectify = false;
  template <class V>
  void each_field(V& visitor) const {
    visitor("x_offset", x_offset);
    visitor("y_offset", y_offset);
    visitor("height", height);
    visitor("width", width);
    visitor("do_rectify", do_rectify);
  }
};

struct CameraInfo {
  static constexpr const char* kType = "sensor_msgs/CameraInfo";
  Header header;
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::string distortion_model;
  std::vector<double> d;
  std::array<double, 9> k{};
  std::array<double, 9> r{};
  std::array<double, 12> p{};
  std::uint32_t binning_x = 0;
  std::uint32_t binning_y = 0;
  RegionOfInterest roi;
  template <class V>
  void each_field(V& visitor) const {
    visitor("header", header);
    visitor("height", height);
    visitor("width", width);
    visitor("distortion_model", distortion_model);
    visitor("d", d);
    visitor("k", k);
    visitor("r", r);
    visitor("p", p);
    visitor("binning_x", binning_x);
    visitor("binning_y", binning_y);
    visitor("roi", roi);
  }
};

struct LaserScan {
  static constexpr const char* kType = "sensor_msgs/LaserScan";
  Header header;
  float angle_min = 0.0F;
  float angle_max = 0.0F;
  float angle_increment = 0.0F;
  float time_increment = 0.0F;
  float scan_time = 0.0F;
  float range_min = 0.0F;
  float range_max = 0.0F;
  std::vector<float> ranges;
  std::vector<float> intensities;
  template <class V>
  void each_field(V& visitor) const {
    visitor("header", header);
    visitor("angle_min", angle_min);
    visitor("angle_max", angle_max);
    visitor("angle_increment", angle_increment);
    visitor("time_increment", time_increment);
    visitor("scan_time", scan_time);
    visitor("range_min", range_min);
    visitor("range_max", range_max);
    visitor("ranges", ranges);
    visitor("intensities", intensities);
  }
};

struct PointField {
  static constexpr const char* kType = "sensor_msgs/PointField";
  std::string name;
  std::uint32_t offset = 0;
  std::uint8_t datatype = 0;
  std::uint32_t count = 0;
  template <class V>
  void each_field(V& visitor) const {
    visitor("name", name);
    visitor("offset", offset);
    visitor("datatype", datatype);
    visitor("count", count);
  }
};

struct PointCloud2 {
  static constexpr const char* kType = "sensor_msgs/PointCloud2";
  Header header;
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::vector<PointField> fields;
  bool is_bigendian = false;
  std::uint32_t point_step = 0;
  std::uint32_t row_step = 0;
  std::vector<std::uint8_t> data;
  bool is_dense = false;
  template <class V>
  void each_field(V& visitor) const {
    visitor("header", header);
    visitor("height", height);
    visitor("width", width);
    visitor("fields", fields);
    visitor("is_bigendian", is_bigendian);
    visitor("point_step", point_step);
    visitor("row_step", row_step);
    visitor("data", data);
    visitor("is_dense", is_dense);
  }
};

struct BatteryState {
  static constexpr const char* kType = "sensor_msgs/BatteryState";
  Header header;
  float voltage = 0.0F;
  float temperature = 0.0F;
  float current = 0.0F;
  float charge = 0.0F;
  float capacity = 0.0F;
  float design_capacity = 0.0F;
  float percentage = 0.0F;
  std::uint8_t power_supply_status = 0;
  std::uint8_t power_supply_health = 0;
  std::uint8_t power_supply_technology = 0;
  bool present = false;
  std::vector<float> cell_voltage;
  std::vector<float> cell_temperature;
  std::string location;
  std::string serial_number;
  template <class V>
  void each_field(V& visitor) const {
    visitor("header", header);
    visitor("voltage", voltage);
    visitor("temperature", temperature);
    visitor("current", current);
    visitor("charge", charge);
    visitor("capacity", capacity);
    visitor("design_capacity", design_capacity);
    visitor("percentage", percentage);
    visitor("power_supply_status", power_supply_status);
    visitor("power_supply_health", power_supply_health);
    visitor("power_supply_technology", power_supply_technology);
    visitor("present", present);
    visitor("cell_voltage", cell_voltage);
    visitor("cell_temperature", cell_temperature);
    visitor("location", location);
    visitor("serial_number", serial_number);
  }
};

struct DisparityImage {
  static constexpr const char* kType = "stereo_msgs/DisparityImage";
  Header header;
  Image image;
  float f = 0.0F;
  float t = 0.0F;
  RegionOfInterest valid_window;
  float min_disparity = 0.0F;
  float max_disparity = 0.0F;
  float delta_d = 0.0F;
  template <class V>
  void each_field(V& visitor) const {
    visitor("header", header);
    visitor("image", image);
    visitor("f", f);
    visitor("t", t);
    visitor("valid_window", valid_window);
    visitor("min_disparity", min_disparity);
    visitor("max_disparity", max_disparity);
    visitor("delta_d", delta_d);
  }
};

}  // namespace striate::viewer::msgs
