#include <utility>

#include "striate/agent/body.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/pioneer/pioneer_robot.hpp"

namespace striate::agent {

BodySource real_pioneer() {
  return {.wake = [](const RobotSettings& settings) -> Body {
    const pioneer::DevicePlaces& places = settings.pioneer.devices;
    if (places.base.empty() || places.camera.empty()) {
      throw UserError(
          "striate run: without --world the task is run with a real robot, and --robot "
          "FILE must say where its base and its camera are, or its rosbridge server\n"
          "  hint: config/robots/pioneer.yaml does, and turtlebot_rosbridge.yaml");
    }
    auto robot =
        std::make_unique<pioneer::PioneerRobot>(settings.pioneer, described_by(settings.robot));
    const auto hold = [&body = *robot] {
      const pioneer::HoldReason reason = body.driver().report().hold;
      if (reason != pioneer::HoldReason::none) return std::string(name_of(reason));
      const std::string camera = body.camera_trouble();
      return camera.empty() ? camera : "the camera: " + camera;
    };
    const auto waits = [&driver = robot->driver()] { return driver.report().latched; };
    const auto reset = [&robot = *robot] { robot.reset(); };
    return {.robot = std::move(robot),
            .place = places.base,
            .hold = hold,
            .waits_for_reset = waits,
            .reset = reset};
  }};
}

}  // namespace striate::agent
