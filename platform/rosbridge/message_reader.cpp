#include "striate/platform/rosbridge/message_reader.hpp"

#include <fmt/format.h>

#include <exception>
#include <type_traits>
#include <utility>

#include "striate/base/plain_text.hpp"
#include "striate/platform/rosbridge/json_fields.hpp"
#include "striate/platform/rosbridge/operations.hpp"
#include "striate/platform/rosbridge/read_messages.hpp"

namespace striate::rosbridge {
namespace {

using nlohmann::json;
using remote::Eye;

/// Letters of a server's sentence that are shown, by hand: two lines of a terminal
constexpr std::size_t kMostSaid = 160;

std::string said_by(const json& operation) {
  const auto said = operation.find("msg");
  if (said == operation.end()) return "nothing";
  const std::string text = said->is_string() ? said->get<std::string>() : said->dump();
  return plain_text(text.substr(0, kMostSaid));
}

/// `level` is error or warning; what else it tells is no trouble.
Heard read_status(const json& status) {
  const std::string& level = text_at(status, "level");
  if (level != "error" && level != "warning") return HeardNothing{};
  return HeardTrouble{fmt::format("the server says: {}", said_by(status))};
}

}  // namespace

Heard MessageReader::read(std::string_view text) {
  try {
    const json operation = read_object(text);
    const std::string& op = text_at(operation, "op");
    if (op == "publish") {
      const std::string& topic = text_at(operation, "topic");
      return read_message(topic, field_at(operation, "msg"));
    }
    if (op == "status") return read_status(operation);
    if (op == "fragment" || op == "png") {
      return HeardTrouble{
          fmt::format("the server sends messages as '{}', though none was asked for", op)};
    }
    return HeardNothing{};
  } catch (const std::exception& error) {
    return HeardTrouble{plain_text(error.what())};
  }
}

Heard MessageReader::read_message(const std::string& topic, const json& message) {
  const TopicNames& topics = settings_.topics;
  try {
    if (!message.is_object()) throw BadMessage("'msg' is no object");
    if (topic == topics.odometry) {
      return HeardOdometry{odometry_of(message), stamp_ns_of(message)};
    }
    if (topic == topics.left_image) return read_image(Eye::left, message);
    if (topic == topics.right_image) return read_image(Eye::right, message);
    if (topic == topics.left_info) return HeardCamera{Eye::left, eye_info_of(message)};
    if (topic == topics.right_info) return HeardCamera{Eye::right, eye_info_of(message)};
    if (topic == topics.scan && !topic.empty()) {
      return HeardScan{scan_of(message, settings_.scan_forward_m), stamp_ns_of(message)};
    }
  } catch (const std::exception& error) {
    return HeardTrouble{fmt::format("{}: {}", topic, plain_text(error.what()))};
  }
  return HeardNothing{};
}

Heard MessageReader::read_image(Eye eye, const json& message) {
  const std::string& topic =
      eye == Eye::left ? settings_.topics.left_image : settings_.topics.right_image;
  HeardImage heard;
  heard.eye = eye;
  heard.image.stamp_ns = stamp_ns_of(message);
  heard.image.image =
      is_compressed(topic) ? compressed_image_of(message, bits_) : image_of(message, bits_);
  heard.image.bits = bits_;
  return heard;
}

void take(Heard heard, TimePoint arrived, remote::Inbox& inbox) {
  std::visit(
      [&](auto& one) {
        using Kind = std::decay_t<decltype(one)>;
        if constexpr (std::is_same_v<Kind, HeardTrouble>) inbox.refuse(one.what);
        if constexpr (std::is_same_v<Kind, HeardImage>) {
          inbox.take_eye(one.eye, std::move(one.image), arrived);
        }
        if constexpr (std::is_same_v<Kind, HeardCamera>) inbox.take_camera(one.eye, one.info);
        if constexpr (std::is_same_v<Kind, HeardOdometry>) {
          inbox.take_odometry(one.odometry, one.stamp_ns, arrived);
        }
        if constexpr (std::is_same_v<Kind, HeardScan>) {
          inbox.take_laser(std::move(one.scan), one.stamp_ns, arrived);
        }
      },
      heard);
}

}  // namespace striate::rosbridge
