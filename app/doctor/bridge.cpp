#include "striate/app/doctor/bridge.hpp"

#include <fmt/format.h>

#include <exception>

#include "striate/agent/rosbridge_body.hpp"

namespace striate::app {

Findings look_at_bridge(const agent::RobotSettings& settings, Duration patience) {
  const std::string& url = settings.rosbridge.url;
  if (url.empty()) return {};
  try {
    const auto robot = agent::join_rosbridge(settings, patience);
    Senses senses;
    robot->sense(senses);
    return {{Finding::Grade::good, url,
             fmt::format("images of {} x {} and odometry come; nothing was told to move",
                         senses.stereo.left.cols, senses.stereo.left.rows),
             ""}};
  } catch (const std::exception& error) {
    return {{Finding::Grade::wrong, url, error.what(),
             "is the server running, and are the topics those of the robot?"}};
  }
}

}  // namespace striate::app
