#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "striate/platform/interface/motor_command.hpp"
#include "striate/platform/rosbridge/bridge_settings.hpp"

/// What a client says to a rosbridge server, protocol v2 (RobotWebTools, ROSBRIDGE_PROTOCOL.md):
/// one JSON object a message.
namespace striate::rosbridge {

/// A type as the robot's ROS names it: "geometry_msgs", "Twist".
[[nodiscard]] std::string type_name(RosVersion ros, std::string_view package,
                                    std::string_view type);

[[nodiscard]] bool is_compressed(const std::string& image_topic);

/// What is said first on a new line: what is going to be published, and all that is to be heard.
/// @param own_images whether images come by it, too
[[nodiscard]] std::vector<std::string> greetings(const BridgeSettings& settings, bool own_images);

/// What is said last, so that the robot hears nobody any more.
[[nodiscard]] std::vector<std::string> good_byes(const BridgeSettings& settings, bool own_images);

/// A motor command for the robot. @param stamp_ns of the robot's clock, for TwistStamped; without
/// one the server sets its own
[[nodiscard]] std::string publish_twist(const BridgeSettings& settings, const MotorCommand& command,
                                        std::optional<std::int64_t> stamp_ns);

}  // namespace striate::rosbridge
