#include "striate/platform/rosbridge/read_messages.hpp"

#include <cmath>
#include <limits>

#include "striate/base/geometry.hpp"
#include "striate/platform/remote/image_codec.hpp"
#include "striate/platform/rosbridge/json_fields.hpp"

namespace striate::rosbridge {
namespace {

using nlohmann::json;

/// ROS 1 counts seconds in 32 bits, ROS 2 in 31.
constexpr std::int64_t kMostSeconds = 4'294'967'295;
constexpr std::int64_t kNanosecondsASecond = 1'000'000'000;
/// As many echoes as a scan may have (interface/plausible.cpp)
constexpr std::size_t kMostRanges = 100'000;
constexpr std::int64_t kMostUint32 = 4'294'967'295;

std::uint32_t uint32_at(const json& message, std::string_view path) {
  return static_cast<std::uint32_t>(count_at(message, path, kMostUint32));
}

}  // namespace

std::int64_t stamp_ns_of(const json& message) {
  const auto header = message.find("header");
  if (header == message.end() || !header->is_object()) return 0;
  const auto stamp = header->find("stamp");
  if (stamp == header->end() || !stamp->is_object()) return 0;
  const bool two = stamp->contains("sec");
  return count_at(*stamp, two ? "sec" : "secs", kMostSeconds) * kNanosecondsASecond +
         count_at(*stamp, two ? "nanosec" : "nsecs", kNanosecondsASecond - 1);
}

Odometry odometry_of(const json& message) {
  const json& pose = field_at(message, "pose.pose");
  const double x = number_at(pose, "orientation.x");
  const double y = number_at(pose, "orientation.y");
  const double z = number_at(pose, "orientation.z");
  const double w = number_at(pose, "orientation.w");
  if (!(x * x + y * y + z * z + w * w > 0.0)) throw BadMessage("'orientation' points nowhere");
  Odometry odometry;
  odometry.pose = {number_at(pose, "position.x"), number_at(pose, "position.y"),
                   std::atan2(2.0 * (w * z + x * y), w * w + x * x - y * y - z * z)};
  odometry.forward_m_s = number_at(message, "twist.twist.linear.x");
  odometry.turn_rad_s = number_at(message, "twist.twist.angular.z");
  return odometry;
}

RangeScan scan_of(const json& message, double forward_m) {
  const double from_rad = number_at(message, "angle_min");
  const double step_rad = number_at(message, "angle_increment");
  const double least_m = number_at(message, "range_min");
  const double most_m = number_at(message, "range_max");
  const std::vector<double> ranges_m = numbers_at(message, "ranges", kMostRanges);
  RangeScan scan;
  for (std::size_t i = 0; i < ranges_m.size(); ++i) {
    const double range_m = ranges_m[i];
    const double angle_rad = wrap_angle(from_rad + static_cast<double>(i) * step_rad);
    // REP 117: beyond the range is nothing within it; too near, and what is no number, says
    // nothing.
    if (std::isnan(range_m) || range_m < least_m) continue;
    if (range_m > most_m) {
      scan.readings.push_back({angle_rad, std::numeric_limits<double>::infinity()});
      continue;
    }
    const double x_m = forward_m + range_m * std::cos(angle_rad);
    const double y_m = range_m * std::sin(angle_rad);
    scan.readings.push_back({std::atan2(y_m, x_m), std::hypot(x_m, y_m)});
  }
  return scan;
}

remote::EyeInfo eye_info_of(const json& message) {
  remote::EyeInfo info;
  info.width_px = static_cast<int>(count_at(message, "width", 65535));
  const bool one = message.contains("P");
  const std::vector<double> projection =
      numbers_at(message, one ? "P" : "p", info.projection.size());
  if (projection.size() != info.projection.size()) throw BadMessage("'p' has not 12 numbers");
  for (std::size_t i = 0; i < projection.size(); ++i) {
    if (!std::isfinite(projection[i])) throw BadMessage("'p' has what is no number");
    info.projection[i] = projection[i];
  }
  return info;
}

cv::Mat3b image_of(const json& message, int& bits) {
  const std::vector<std::uint8_t> bytes = bytes_at(message, "data");
  remote::RawImage raw;
  raw.width = uint32_at(message, "width");
  raw.height = uint32_at(message, "height");
  raw.step = uint32_at(message, "step");
  raw.encoding = text_at(message, "encoding");
  const json& turned = field_at(message, "is_bigendian");
  raw.big_endian =
      turned.is_boolean() ? turned.get<bool>() : uint32_at(message, "is_bigendian") != 0;
  raw.data = bytes.data();
  raw.size = bytes.size();
  return remote::decode(raw, bits);
}

cv::Mat3b compressed_image_of(const json& message, int& bits) {
  const std::vector<std::uint8_t> bytes = bytes_at(message, "data");
  return remote::decode_compressed(bytes.data(), bytes.size(), bits);
}

}  // namespace striate::rosbridge
