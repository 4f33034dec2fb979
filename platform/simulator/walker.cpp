#include "striate/platform/simulator/walker.hpp"

#include <algorithm>
#include <cmath>

#include "striate/base/stopping_speed.hpp"
#include "striate/platform/simulator/obstacle_shapes.hpp"

namespace striate::simulator {
namespace {

/// Stands within half a second from a quick walk of 1.5 m/s
constexpr double kAcceleration_m_s2 = 3.0;
constexpr double kTurning_rad_s = 5.0;  ///< turns round within 0.6 s
constexpr double kTwoSteps_m = 1.4;     ///< length of a stride, both legs once: 0.7 m a step
constexpr double kHeldUp_m_s = 0.1;     ///< slower is held up
constexpr double kFaces_m_s = 0.2;      ///< slower, he does not turn to where he goes
constexpr double kLegs_m_s = 0.05;      ///< slower, the legs come together
constexpr double kThere_m = 0.12;       ///< so near to its end a way has been walked: half a radius

}  // namespace

double stopping_distance_m(double forward_m_s, const RobotDescription& robot) {
  constexpr double kReaction_s = 0.3;  // 85 ms image, 100 ms cycle, 60 ms motors, and a little
  return stopping_way(forward_m_s, robot.max_acceleration_m_s2, kReaction_s);
}

void Walker::appear(Pose2 at, int look) {
  *this = Walker();
  present_ = true;
  state_.pose = at;
  state_.look = look;
  facing_rad_ = at.heading_rad;
}

void Walker::go(std::vector<Point2> way, double speed_m_s, std::vector<Point2> doors) {
  way_ = std::move(way);
  doors_ = std::move(doors);
  speed_m_s_ = speed_m_s;
  progress_m_ = 0.0;
  held_up_s_ = 0.0;
  length_m_ = 0.0;
  for (std::size_t i = 0; i + 1 < way_.size(); ++i) length_m_ += distance_m(way_[i], way_[i + 1]);
}

bool Walker::arrived() const {
  return way_.empty() || distance_m(at(), way_.back()) < kThere_m;
}

void Walker::face(Point2 place) {
  facing_rad_ = std::atan2(place.y_m - state_.pose.y_m, place.x_m - state_.pose.x_m);
}

void Walker::step(double dt_s, const Surroundings& around) {
  const double dx = wanted_x_m_s_ - velocity_x_m_s_;
  const double dy = wanted_y_m_s_ - velocity_y_m_s_;
  const double change = std::hypot(dx, dy);
  const double share = change > 0.0 ? std::min(1.0, kAcceleration_m_s2 * dt_s / change) : 0.0;
  velocity_x_m_s_ += share * dx;
  velocity_y_m_s_ += share * dy;
  const Point2 next{state_.pose.x_m + velocity_x_m_s_ * dt_s,
                    state_.pose.y_m + velocity_y_m_s_ * dt_s};
  if (!may_step_to(next, around)) {
    velocity_x_m_s_ = 0.0;
    velocity_y_m_s_ = 0.0;
  }
  state_.pose.x_m += velocity_x_m_s_ * dt_s;
  state_.pose.y_m += velocity_y_m_s_ * dt_s;
  state_.speed_m_s = std::hypot(velocity_x_m_s_, velocity_y_m_s_);
  held_up_s_ = !arrived() && state_.speed_m_s < kHeldUp_m_s ? held_up_s_ + dt_s : 0.0;
  if (state_.speed_m_s > kFaces_m_s) facing_rad_ = std::atan2(velocity_y_m_s_, velocity_x_m_s_);
  turn_towards(facing_rad_, dt_s);
  swing_legs(dt_s);
}

void Walker::turn_towards(double heading_rad, double dt_s) {
  const double turn = wrap_angle(heading_rad - state_.pose.heading_rad);
  const double most = kTurning_rad_s * dt_s;
  state_.pose.heading_rad = wrap_angle(state_.pose.heading_rad + std::clamp(turn, -most, most));
}

void Walker::swing_legs(double dt_s) {
  using std::numbers::pi;
  if (state_.speed_m_s > kLegs_m_s) {
    state_.stride_rad += 2 * pi * state_.speed_m_s * dt_s / kTwoSteps_m;
  } else {  // the legs come together
    const double rest = std::round(state_.stride_rad / pi) * pi;
    state_.stride_rad += std::clamp(rest - state_.stride_rad, -4.0 * dt_s, 4.0 * dt_s);
  }
  state_.stride_rad = std::fmod(state_.stride_rad, 2 * pi);
}

}  // namespace striate::simulator
