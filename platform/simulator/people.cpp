#include "striate/platform/simulator/people.hpp"

#include <fmt/format.h>

#include <cmath>

#include "striate/platform/simulator/obstacle_shapes.hpp"

namespace striate::simulator {
namespace {

constexpr std::uint64_t kStepsPerDecision = 10;  ///< of 10 ms: people decide ten times a second
/// Farther people change nothing of where a walker steps within kMoments (walker.cpp): 1.8 s at 1.5
/// m/s each.
constexpr double kSeesOthers_m = 6.0;

}  // namespace

People::People(const World& world, const FloorPlan& plan, const RobotDescription& robot,
               std::uint64_t seed)
    : world_(world), plan_(plan), map_(world, plan), doors_(doorways(world, plan, map_)) {
  place_ = {&world_, &plan_, &map_, &doors_, robot};
  around_.map = &map_;
  around_.footprint = robot_footprint(robot);
  add_walks(seed);
  for (std::size_t i = 0; i < world.steps_in_front.size(); ++i) {
    steppers_.emplace_back(world.steps_in_front[i], seed, i + 1);
  }
  const Random random(seed, Purpose::walk);
  for (std::size_t i = 0; i < world.standers.size(); ++i) {
    const Stander& stander = world.standers[i];
    Pose2 pose = plan.at(stander.at.x_m, stander.at.y_m);
    pose.heading_rad += stander.heading_rad;
    standers_.emplace_back().appear(pose, static_cast<int>(random.bits(1000 + i) % 64));
  }
  slots_.resize(walks_.size() + steppers_.size() + standers_.size());
  bodies_.resize(slots_.size());
  publish(1.0);
}

void People::step(double now_s, double dt_s, const RobotMotion& robot) {
  look_round(robot);
  if (steps_++ % kStepsPerDecision == 0) decide(now_s);
  for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
    Walker* walker = walker_of(slot);
    if (!walker->present()) continue;
    see_others(slot);
    walker->step(dt_s, around_);
  }
  publish(dt_s);
}

void People::look_round(const RobotMotion& robot) {
  around_.robot = robot.pose;
  around_.robot_forward_m_s = robot.forward_m_s;
  around_.robot_turn_rad_s = robot.turn_rad_s;
  around_.body = moved(around_.footprint, robot.pose);
  const double way =
      std::copysign(stopping_distance_m(robot.forward_m_s, place_.robot), robot.forward_m_s);
  ConvexShape swept = around_.footprint;
  for (Point2& corner : swept.corners) {
    if ((corner.x_m > 0.0) == (way > 0.0)) corner.x_m += way;
  }
  around_.braking = moved(swept, robot.pose);
}

Walker* People::walker_of(std::size_t slot) {
  if (slot < walks_.size()) return &walks_[slot].walker;
  slot -= walks_.size();
  if (slot < steppers_.size()) return &steppers_[slot].walker();
  return &standers_[slot - steppers_.size()];
}

void People::see_others(std::size_t slot) {
  around_.others.clear();
  const Point2 here = walker_of(slot)->at();
  for (std::size_t other = 0; other < slots_.size(); ++other) {
    const Walker* walker = walker_of(other);
    if (other == slot || !walker->present()) continue;
    if (distance_m(here, walker->at()) < kSeesOthers_m) around_.others.push_back(walker->passer());
  }
}

void People::decide(double now_s) {
  for (Walking& walking : walks_) {
    see_others(walking.slot);
    decide_walk(walking, now_s);
  }
  for (std::size_t i = 0; i < steppers_.size(); ++i) {
    if (steppers_[i].walker().present()) {
      see_others(walks_.size() + i);
    } else {  // he may appear anywhere, so he looks at everybody
      around_.others.clear();
      for (std::size_t other = 0; other < slots_.size(); ++other) {
        if (walker_of(other)->present()) around_.others.push_back(walker_of(other)->passer());
      }
    }
    steppers_[i].decide(now_s, place_, around_);
  }
}

std::string People::name(std::size_t slot) const {
  return fmt::format("person_{}", slot + 1);
}

std::vector<PersonState> People::states() const {
  std::vector<PersonState> states;
  for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
    if (bodies_[slot].present) states.push_back(slots_[slot]);
  }
  return states;
}

void People::publish(double dt_s) {
  for (std::size_t slot = 0; slot < slots_.size(); ++slot) {
    const Walker* walker = walker_of(slot);
    PersonBody& body = bodies_[slot];
    const Passer passer = walker->passer();
    body.present = walker->present();
    body.velocity_x_m_s = passer.velocity_x_m_s;
    body.velocity_y_m_s = passer.velocity_y_m_s;
    // The physics moves him itself from where he was.
    body.at = {passer.at.x_m - passer.velocity_x_m_s * dt_s,
               passer.at.y_m - passer.velocity_y_m_s * dt_s};
    slots_[slot] = walker->state();
    slots_[slot].carries = slot < walks_.size() && world_.walks[slot].carries;
  }
}

}  // namespace striate::simulator
