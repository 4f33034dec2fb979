#include "striate/agent/teaching/standing_robot.hpp"

namespace striate::agent {

StandingRobot::StandingRobot(const simulator::World& world, const simulator::FloorPlan& plan,
                             const RobotSettings& settings, std::uint64_t seed)
    : description_(simulated_robot(settings)), renderer_(world, plan, settings.camera, seed) {
  scene_.head.tilt_rad = description_.resting_tilt_rad;
}

bool StandingRobot::sense(Senses& senses) {
  clock_.advance(description_.cycle);
  ++scene_.frame;
  scene_.time_s = to_seconds(clock_.now());
  senses.now = clock_.now();
  senses.stereo = renderer_.image(scene_);
  senses.stereo.stamp = senses.now;
  senses.stereo.head = scene_.head;
  senses.odometry = {senses.now, {}, 0.0, 0.0};
  senses.head = scene_.head;
  return true;
}

void StandingRobot::send(const MotorCommand& command) {
  scene_.head = {command.pan_rad, command.tilt_rad};
}

}  // namespace striate::agent
