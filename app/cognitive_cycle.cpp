#include "app/cognitive_cycle.hpp"

namespace striate {

CognitiveCycle::CognitiveCycle(Robot& robot, const RobotSettings& settings, Executive& executive)
    : robot_(robot),
      executive_(executive),
      perception_(settings.perception, robot.description()),
      memory_(settings.memory, robot.description()),
      limiter_(settings.safety, robot.description()) {}

CognitiveCycle::~CognitiveCycle() {
  robot_.stop();
}

/// One cycle of the robot: from light to motion.
bool CognitiveCycle::step() {
  if (!robot_.sense(trace_.senses)) return false;
  see();
  remember();
  want();
  move();
  return !executive_.ended();
}

/// V1 -> stereo -> obstacles, motion, corridor, saliency, keypoints. A picture is looked at once.
void CognitiveCycle::see() {
  odometry_.add(trace_.senses.odometry.stamp, trace_.senses.odometry.pose);
  const StereoFrame& picture = trace_.senses.stereo;
  const bool is_new = !picture.left.empty() && picture.stamp != trace_.percept.stamp;
  if (is_new) trace_.percept = perception_.see(picture, odometry_.at(picture.stamp));
}

/// What was seen is put where it was seen, moved by odometry; what is old fades.
void CognitiveCycle::remember() {
  memory_.update(trace_.senses, trace_.percept);
}

/// The task script picks the behaviour, the behaviour says what it wants. A pilot goes before it.
void CognitiveCycle::want() {
  trace_.wish = executive_.tick(memory_, trace_.senses.now);
  if (executive_.owner() != MotorOwner::guard) arbiter_.release(MotorOwner::guard);
  arbiter_.offer(executive_.owner(), trace_.wish);
  arbiter_.release(MotorOwner::pilot);
  if (!pilot_) return;
  if (const std::optional<Wish> wish = pilot_(trace_.senses.now)) {
    arbiter_.offer(MotorOwner::pilot, *wish);
  }
}

/// One owner of the motors, one gate to them; what was really sent is remembered.
void CognitiveCycle::move() {
  const Wish wish = arbiter_.decide(trace_.senses.now);
  trace_.sent = limiter_.limit(wish, trace_.senses, memory_);
  trace_.limited_by = limiter_.reason();
  robot_.send(trace_.sent);
  memory_.remember(trace_.sent, executive_.current_action());
}

}  // namespace striate
