#include "app/cognitive_cycle.hpp"

namespace striate {

CognitiveCycle::CognitiveCycle(Robot& robot, const RobotSettings& settings, Executive& executive)
    : robot_(robot),
      executive_(executive),
      perception_(settings.perception, robot.description()),
      memory_(settings.memory, robot.description()),
      limiter_(settings.safety, robot.description()) {
  perception_.landmarks().set_clock(&robot.clock());
}

CognitiveCycle::~CognitiveCycle() {
  robot_.stop();
}

/// Object models are defined in perception, kept by memory, and handed in here.
void CognitiveCycle::know(FamiliarLandmarks landmarks) {
  landmarks_ = std::move(landmarks);
  landmarks_.hand_over(perception_.landmarks());
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

/// V1 -> stereo -> obstacles, motion, corridor, saliency, keypoints, recognition of landmarks,
/// where memory guides the eye. A picture is looked at once.
void CognitiveCycle::see() {
  odometry_.add(trace_.senses.odometry.stamp, trace_.senses.odometry.pose);
  const StereoFrame& picture = trace_.senses.stereo;
  const bool is_new = !picture.left.empty() && picture.stamp != trace_.percept.stamp;
  if (!is_new) return;
  const Pose2 base = odometry_.at(picture.stamp);
  landmarks_.guide(memory_, base, perception_.landmarks());
  trace_.percept = perception_.see(picture, base);
}

/// What was seen is put where it was seen, moved by odometry; what is old fades. Landmarks get
/// their names, and what they teach is noted.
void CognitiveCycle::remember() {
  memory_.update(trace_.senses, trace_.percept);
  trace_.sightings = landmarks_.name(trace_.percept);
  for (const LandmarkSighting& sighting : trace_.sightings) memory_.recognise(sighting);
  trace_.lessons = landmarks_.learn(trace_.percept, memory_);
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
