#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "striate/base/base64.hpp"

/// Messages as a robot sends them.
namespace striate::rosbridge {

inline nlohmann::json header(bool ros_two, std::int64_t stamp_ns) {
  return {{"frame_id", "any"},
          {"stamp",
           {{ros_two ? "sec" : "secs", stamp_ns / 1'000'000'000},
            {ros_two ? "nanosec" : "nsecs", stamp_ns % 1'000'000'000}}}};
}

inline nlohmann::json odometry_message(bool ros_two, std::int64_t stamp_ns, double x_m,
                                       double forward_m_s) {
  return {{"header", header(ros_two, stamp_ns)},
          {"pose",
           {{"pose",
             {{"position", {{"x", x_m}, {"y", -2.0}, {"z", 0.0}}},
              {"orientation", {{"x", 0.0}, {"y", 0.0}, {"z", 1.0}, {"w", 1.0}}}}}}},
          {"twist",
           {{"twist",
             {{"linear", {{"x", forward_m_s}, {"y", 0}, {"z", 0}}},
              {"angular", {{"x", 0}, {"y", 0}, {"z", -0.25}}}}}}}};
}

/// @param place_m of the eye to the right of the left one
inline nlohmann::json camera_message(bool ros_two, double place_m) {
  return {{"width", 64},
          {"height", 48},
          {ros_two ? "p" : "P", {60.0, 0, 31.5, -60.0 * place_m, 0, 60.0, 23.5, 0, 0, 0, 1, 0}}};
}

inline nlohmann::json image_message(bool ros_two, std::int64_t stamp_ns) {
  const std::vector<std::uint8_t> pixels(std::size_t{64} * 48 * 3, 77);
  return {{"header", header(ros_two, stamp_ns)},
          {"width", 64},
          {"height", 48},
          {"step", 192},
          {"is_bigendian", 0},
          {"encoding", "rgb8"},
          {"data", to_base64(pixels)}};
}

inline nlohmann::json scan_message(bool ros_two, std::int64_t stamp_ns) {
  return {{"header", header(ros_two, stamp_ns)},
          {"angle_min", -0.5},
          {"angle_increment", 0.5},
          {"range_min", 0.1},
          {"range_max", 10.0},
          {"ranges", {nullptr, 2.0, 20.0}}};
}

inline std::string published(const std::string& topic, const nlohmann::json& message) {
  return nlohmann::json{{"op", "publish"}, {"topic", topic}, {"msg", message}}.dump();
}

}  // namespace striate::rosbridge
