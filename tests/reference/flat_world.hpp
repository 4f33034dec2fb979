#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "striate/base/geometry.hpp"
#include "striate/platform/interface/robot.hpp"

/// A flat test world: walls, things and people on a plane, and a differential drive among them.
/// Nothing is rendered, so that closed loops of thousands of cycles run in a second. It is a
/// reference for tests of memory and behaviours, not the simulator that runs are judged in.
namespace striate::flat {

/// Counter-based: number n of stream s is the same on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed * 0x9E3779B97F4A7C15ULL + 0x1234567ULL) {}
  std::uint64_t bits() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ULL);
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
  }
  double unit() { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; }
  double between(double low, double high) { return low + (high - low) * unit(); }
  bool chance(double probability) { return unit() < probability; }
  double normal() {  // Irwin-Hall: twelve uniforms, exact on every machine
    double sum = -6.0;
    for (int i = 0; i < 12; ++i) sum += unit();
    return sum;
  }

 private:
  std::uint64_t state_;
};

/// A vertical face seen from above. `blank`: too plain for stereo.
struct Face {
  Point2 from;
  Point2 to;
  double bottom_m = 0.0;
  double top_m = 2.7;
  bool blank = false;
};

struct Column2 {  ///< a round thing: pillar, leg
  Point2 at;
  double radius_m = 0.1;
  double top_m = 2.7;
};

/// A person who waits at `path[0]` until the robot is `starts_at_m` away along x, then walks the
/// path, pausing `pause_s` at its second point.
struct Person {
  std::vector<Point2> path;
  double speed_m_s = 1.0;
  double starts_at_m = 6.0;
  double pause_s = 0.0;
  bool present_before = true;  ///< seen before it starts
  bool present_after = true;   ///< seen after its last point
  // State.
  Point2 at;
  bool started = false;
  std::size_t next = 1;
  double paused_s = 0.0;
  double held_s = 0.0;
  [[nodiscard]] bool present() const {
    if (!started) return present_before;
    return next < path.size() || present_after;
  }
};
inline constexpr double kPersonRadius_m = 0.22;
inline constexpr double kPersonTop_m = 1.75;

struct Layout {
  std::vector<Face> faces;
  std::vector<Column2> columns;
  std::vector<Person> people;
  Pose2 start;
  double goal_x_m = 30.0;
  bool corridor_views = true;  ///< whether images show the corridor now and then
};

inline void add_box(Layout& layout, Point2 middle, double long_m, double wide_m, double turn_rad,
                    double bottom_m, double top_m, bool blank = false) {
  const Pose2 pose{middle.x_m, middle.y_m, turn_rad};
  const double a = 0.5 * long_m;
  const double b = 0.5 * wide_m;
  const Point2 corner[4] = {transform(pose, Point2{a, b}), transform(pose, Point2{-a, b}),
                            transform(pose, Point2{-a, -b}), transform(pose, Point2{a, -b})};
  for (int i = 0; i < 4; ++i) {
    layout.faces.push_back({corner[i], corner[(i + 1) % 4], bottom_m, top_m, blank});
  }
}

inline double distance_to_face(Point2 p, const Face& face) {
  const double dx = face.to.x_m - face.from.x_m;
  const double dy = face.to.y_m - face.from.y_m;
  const double squared = dx * dx + dy * dy;
  const double t =
      squared > 0.0
          ? std::clamp(((p.x_m - face.from.x_m) * dx + (p.y_m - face.from.y_m) * dy) / squared, 0.0,
                       1.0)
          : 0.0;
  return std::hypot(p.x_m - face.from.x_m - t * dx, p.y_m - face.from.y_m - t * dy);
}

/// The robot and everything that moves, advanced in steps of 10 ms.
class World {
 public:
  World(Layout layout, const RobotDescription& robot, std::uint64_t seed)
      : layout_(std::move(layout)), robot_(robot), pose_(layout_.start) {
    Random random(seed ^ 0xABCDEFULL);
    way_error_ = 1.0 + 0.0075 * random.normal();
    turn_error_ = 1.0 + 0.0075 * random.normal();
    turn_bias_rad_m_ = 0.0015 * random.normal();
    for (Person& person : layout_.people) person.at = person.path[0];
  }

  void send(const MotorCommand& command) { command_ = command; }

  /// Other things stand there from now on.
  void change(const Layout& layout) { layout_ = layout; }

  void advance(double seconds) {
    const int steps = static_cast<int>(std::lround(seconds / 0.01));
    for (int i = 0; i < steps && !touched_; ++i) step(0.01);
  }

  [[nodiscard]] const Layout& layout() const { return layout_; }
  [[nodiscard]] const Pose2& pose() const { return pose_; }
  [[nodiscard]] const Pose2& odometry() const { return odometry_; }
  [[nodiscard]] double forward_m_s() const { return forward_; }
  [[nodiscard]] double turn_rad_s() const { return turn_; }
  [[nodiscard]] HeadPose head() const { return head_; }
  [[nodiscard]] double time_s() const { return time_s_; }
  [[nodiscard]] bool touched() const { return touched_; }
  [[nodiscard]] double nearest_m() const { return nearest_m_; }
  [[nodiscard]] bool touched_person() const { return touched_person_; }

  /// Least distance of the robot's outline from anything now; 0 touches.
  [[nodiscard]] double clearance_m() {
    double least = 1e9;
    for (const Face& face : layout_.faces) least = std::min(least, face_distance(face));
    for (const Column2& column : layout_.columns) {
      least = std::min(least, point_distance(column.at) - column.radius_m);
    }
    for (const Person& person : layout_.people) {
      if (!person.present()) continue;
      const double gap_m = point_distance(person.at) - kPersonRadius_m;
      touched_person_ = touched_person_ || gap_m <= 0.0;
      least = std::min(least, gap_m);
    }
    return std::max(0.0, least);
  }

 private:
  [[nodiscard]] double point_distance(Point2 world) const {
    const Point2 p = inverse_transform(pose_, world);
    const double dx = std::max({p.x_m - robot_.front_m, -robot_.rear_m - p.x_m, 0.0});
    const double dy = std::max(std::abs(p.y_m) - robot_.half_width_m, 0.0);
    return std::hypot(dx, dy);
  }

  [[nodiscard]] double face_distance(const Face& face) const {
    if (distance_to_face({pose_.x_m, pose_.y_m}, face) > 1.0) return 0.6;
    double least = std::min(point_distance(face.from), point_distance(face.to));
    const double length_m = std::hypot(face.to.x_m - face.from.x_m, face.to.y_m - face.from.y_m);
    const int parts = std::max(1, static_cast<int>(length_m / 0.02));
    const Point2 near = inverse_transform(pose_, face.from);
    static_cast<void>(near);
    for (int i = 1; i < parts; ++i) {
      const double t = static_cast<double>(i) / parts;
      const Point2 p{face.from.x_m + t * (face.to.x_m - face.from.x_m),
                     face.from.y_m + t * (face.to.y_m - face.from.y_m)};
      if (std::abs(p.x_m - pose_.x_m) > 1.0 || std::abs(p.y_m - pose_.y_m) > 1.0) continue;
      least = std::min(least, point_distance(p));
    }
    return least;
  }

  void step(double dt) {
    time_s_ += dt;
    const auto ease = [dt](double from, double to, double limit) {
      return from + std::clamp(to - from, -limit * dt, limit * dt);
    };
    forward_ = ease(forward_, command_.forward_m_s, robot_.max_acceleration_m_s2);
    turn_ = ease(turn_, command_.turn_rad_s, robot_.max_turn_acceleration_rad_s2);
    head_.pan_rad = ease(head_.pan_rad, command_.pan_rad, 1.2);
    head_.tilt_rad = ease(head_.tilt_rad, command_.tilt_rad, 1.2);
    pose_ = transform(pose_, Pose2{forward_ * dt, 0.0, turn_ * dt});
    const double felt_turn = turn_ * turn_error_ + forward_ * turn_bias_rad_m_;
    odometry_ = transform(odometry_, Pose2{forward_ * way_error_ * dt, 0.0, felt_turn * dt});
    for (Person& person : layout_.people) move(person, dt);
    if (++ticks_ % 2 == 0) {
      const double clear_m = clearance_m();
      nearest_m_ = std::min(nearest_m_, clear_m);
      touched_ = clear_m <= 0.0;
    }
  }

  // People see the robot: they stop before it, and after a while walk round it.
  void move(Person& person, double dt) {
    if (!person.started) {
      person.started = person.path[0].x_m - pose_.x_m < person.starts_at_m;
      return;
    }
    if (person.next >= person.path.size()) return;
    const Point2 target = person.path[person.next];
    const double dx = target.x_m - person.at.x_m;
    const double dy = target.y_m - person.at.y_m;
    const double left_m = std::hypot(dx, dy);
    const double step_m = person.speed_m_s * dt;
    if (left_m <= step_m) {
      person.paused_s += dt;
      if (person.next != 1 || person.paused_s >= person.pause_s) ++person.next;
      return;
    }
    Point2 to{person.at.x_m + dx / left_m * step_m, person.at.y_m + dy / left_m * step_m};
    const double now_m = point_distance(person.at) - kPersonRadius_m;
    const double then_m = point_distance(to) - kPersonRadius_m;
    const double polite_m = person.held_s < 2.0 ? 0.55 : 0.25;
    if (then_m < polite_m && then_m < now_m) {
      person.held_s += dt;
      if (person.held_s < 2.0) return;
      // Round the robot on the roomier side.
      const double aside = person.at.y_m < pose_.y_m ? -1.0 : 1.0;
      to = {person.at.x_m, std::clamp(person.at.y_m + aside * step_m, -0.9, 0.9)};
      if (point_distance(to) - kPersonRadius_m < now_m - 1e-9) return;
    }
    person.at = to;
  }

  Layout layout_;
  RobotDescription robot_;
  Pose2 pose_;
  Pose2 odometry_;
  MotorCommand command_;
  double forward_ = 0.0;
  double turn_ = 0.0;
  HeadPose head_;
  double way_error_ = 1.0;
  double turn_error_ = 1.0;
  double turn_bias_rad_m_ = 0.0;
  double time_s_ = 0.0;
  std::uint64_t ticks_ = 0;
  double nearest_m_ = 1e9;
  bool touched_ = false;
  bool touched_person_ = false;
};

}  // namespace striate::flat
