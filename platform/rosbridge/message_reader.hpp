#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <variant>

#include "striate/platform/remote/inbox.hpp"
#include "striate/platform/rosbridge/bridge_settings.hpp"

namespace striate::rosbridge {

struct HeardImage {
  remote::Eye eye = remote::Eye::left;
  remote::EyeImage image;
};
struct HeardCamera {
  remote::Eye eye = remote::Eye::left;
  remote::EyeInfo info;
};
struct HeardOdometry {
  Odometry odometry;
  std::int64_t stamp_ns = 0;
};
struct HeardScan {
  RangeScan scan;
  std::int64_t stamp_ns = 0;
};
/// What the server says of our requests, or why its message cannot be used.
struct HeardTrouble {
  std::string what;
};
/// Nothing that is any business of ours.
struct HeardNothing {};

using Heard =
    std::variant<HeardNothing, HeardTrouble, HeardImage, HeardCamera, HeardOdometry, HeardScan>;

/// Understands what a rosbridge server sends: whatever it is, something heard or a trouble in plain
/// words. No thread, no clock; knows how many bits the camera's pixels have used so far.
class MessageReader {
 public:
  explicit MessageReader(const BridgeSettings& settings) : settings_(settings) {}

  [[nodiscard]] Heard read(std::string_view text);

 private:
  [[nodiscard]] Heard read_message(const std::string& topic, const nlohmann::json& message);
  [[nodiscard]] Heard read_image(remote::Eye eye, const nlohmann::json& message);

  BridgeSettings settings_;
  int bits_ = 8;
};

/// Puts into the inbox what was heard.
void take(Heard heard, TimePoint arrived, remote::Inbox& inbox);

}  // namespace striate::rosbridge
