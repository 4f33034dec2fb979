#include "striate/behaviours/avoid.hpp"

#include <cmath>
#include <numbers>

#include "striate/behaviours/traverse_corridor.hpp"

namespace striate::behaviours {
namespace {

constexpr int kOpenTicks = 5;          // by hand, half a second: a flicker is no opening
constexpr double kAligned_rad = 0.25;  // by hand, 14 degrees: what comes next drives straight on

}  // namespace

Avoid::Avoid(const Settings& settings, const RobotDescription& robot)
    : settings_(settings), robot_(robot), follower_(settings.driving, robot) {}

void Avoid::start(const memory::ShortTermMemory& memory) {
  const double off_rad = wrap_angle(memory.pose().heading_rad - memory.corridor().axis_rad());
  back_ = std::abs(off_rad) > 0.5 * std::numbers::pi;
  open_ticks_ = 0;
  follower_.start(memory);
}

bool Avoid::straight_path_open(const memory::ShortTermMemory& memory, const Course& course) const {
  const Pose2 line{memory.pose().x_m, memory.pose().y_m, course.direction_rad};
  for (double s = 0.0; s <= settings_.open_m; s += 0.1) {
    const double margin_m =
        follower_.field().clearance_m(transform(line, Point2{s, 0.0})) - robot_.half_width_m;
    if (margin_m < settings_.driving.least_margin_m) return false;
  }
  return std::abs(wrap_angle(memory.pose().heading_rad - course.direction_rad)) < kAligned_rad;
}

Wish Avoid::tick(const memory::ShortTermMemory& memory) {
  const Course course = corridor_course(memory.corridor(), back_, settings_.speed_m_s);
  Wish wish = follower_.tick(memory, course);
  open_ticks_ = straight_path_open(memory, course) ? open_ticks_ + 1 : 0;
  if (wish.progress == Progress::running && open_ticks_ >= kOpenTicks) {
    return final_wish(memory, Progress::succeeded, "the way ahead is open");
  }
  return wish;
}

}  // namespace striate::behaviours
