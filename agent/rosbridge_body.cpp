#include "striate/agent/rosbridge_body.hpp"

#include <utility>

#include "striate/platform/pioneer/camera/make_stereo_camera.hpp"

namespace striate::agent {
namespace {

/// None of our own: images come as topics.
rosbridge::MakeCamera own_camera(const pioneer::PioneerSettings& settings) {
  if (settings.devices.camera.empty()) return {};
  return [place = settings.devices.camera, camera = settings.camera](const Clock& clock) {
    const std::shared_ptr<pioneer::StereoCamera> eyes =
        pioneer::make_stereo_camera(place, camera, clock);
    return rosbridge::OwnCamera{.newest = [eyes] { return eyes->newest(); },
                                .trouble = [eyes] { return eyes->trouble(); }};
  };
}

/// A camera of our own says where it sits as that of a real Pioneer does.
RobotDescription described(const RobotSettings& settings) {
  RobotDescription robot = simulated_robot(settings);
  if (settings.pioneer.devices.camera.empty()) return robot;
  const pioneer::StereoCameraSettings& camera = settings.pioneer.camera;
  robot.camera_height_m = camera.height_m;
  robot.camera_forward_m = camera.forward_m;
  robot.resting_tilt_rad = camera.resting_tilt_rad;
  robot.view_rad = camera.field_rad;
  return robot;
}

}  // namespace

std::unique_ptr<rosbridge::RosbridgeRobot> join_rosbridge(const RobotSettings& settings,
                                                          Duration patience) {
  const RobotDescription robot = described(settings);
  rosbridge::BridgeSettings bridge = settings.rosbridge;
  if (bridge.fixed_tilt_rad == 0.0) bridge.fixed_tilt_rad = robot.resting_tilt_rad;
  return std::make_unique<rosbridge::RosbridgeRobot>(bridge, robot, own_camera(settings.pioneer),
                                                     patience);
}

BodySource robot_behind_rosbridge() {
  return {.wake = [](const RobotSettings& settings) -> Body {
    auto robot = join_rosbridge(settings);
    const auto hold = [&gate = *robot] { return gate.hold(); };
    const auto waits = [&gate = *robot] { return gate.waits_for_reset(); };
    const auto reset = [&gate = *robot] { gate.reset(); };
    return {.robot = std::move(robot),
            .place = settings.rosbridge.url,
            .hold = hold,
            .waits_for_reset = waits,
            .reset = reset};
  }};
}

}  // namespace striate::agent
