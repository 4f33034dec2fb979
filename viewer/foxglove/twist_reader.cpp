#include "striate/viewer/foxglove/twist_reader.hpp"

#include <nlohmann/json.hpp>

namespace striate::viewer::foxglove {
namespace {

using TwistJson = nlohmann::json;

bool is_stamped(const ClientChannel& channel) {
  return channel.schema_name == "geometry_msgs/msg/TwistStamped" ||
         channel.schema_name == "geometry_msgs/TwistStamped";
}

bool is_plain(const ClientChannel& channel) {
  return channel.schema_name == "geometry_msgs/msg/Twist" ||
         channel.schema_name == "geometry_msgs/Twist";
}

double number_in(const TwistJson& json, const char* vector, const char* axis) {
  const auto& value = json.at(vector).at(axis);
  if (!value.is_number()) throw BadBytes("a speed is no number");
  return value.get<double>();
}

WantedMotion read_json_twist(ByteView payload, bool stamped) {
  try {
    const TwistJson json = TwistJson::parse(payload.begin(), payload.end());
    const TwistJson& twist = stamped ? json.at("twist") : json;
    return {number_in(twist, "linear", "x"), number_in(twist, "angular", "z")};
  } catch (const TwistJson::exception&) {
    throw BadBytes("is no Twist in JSON");
  }
}

WantedMotion read_cdr_twist(ByteView payload, bool stamped) {
  ByteReader reader(payload);
  // CDR, little-endian: 00 01, and two bytes of options
  if (reader.u8() != 0 || reader.u8() != 1) throw BadBytes("is no little-endian CDR");
  reader.u16();
  if (stamped) {
    reader.i32();  // seconds
    reader.u32();  // nanoseconds
    const std::size_t frame_bytes = reader.take_block().size();
    // Numbers of eight bytes stand at multiples of eight, counted after the head.
    constexpr std::size_t kStampAndCount = 12;
    for (std::size_t at = kStampAndCount + frame_bytes; at % 8 != 0; ++at) reader.u8();
  }
  WantedMotion motion;
  motion.forward_m_s = reader.take<double>();
  for (int skipped = 0; skipped < 4; ++skipped) reader.take<double>();  // up to angular.z
  motion.turn_rad_s = reader.take<double>();
  reader.expect_end();
  return motion;
}

}  // namespace

bool is_twist(const ClientChannel& channel) {
  return (is_stamped(channel) || is_plain(channel)) &&
         (channel.encoding == "cdr" || channel.encoding == "json");
}

WantedMotion read_twist(const ClientChannel& channel, ByteView payload) {
  return channel.encoding == "json" ? read_json_twist(payload, is_stamped(channel))
                                    : read_cdr_twist(payload, is_stamped(channel));
}

}  // namespace striate::viewer::foxglove
