#include "striate/behaviours/traverse_corridor.hpp"

#include <cmath>
#include <numbers>

namespace striate::behaviours {
namespace {

// By hand, a standard deviation: half the room beside the robot in a gap of 1.2 m.
constexpr double kSureOffset_m = 0.20;

}  // namespace

Course corridor_course(const memory::CorridorMemory& corridor, bool back, double cruise_m_s) {
  Course course;
  course.direction_rad = wrap_angle(corridor.axis_rad() + (back ? std::numbers::pi : 0.0));
  course.wanted_left_m = back ? corridor.offset_m() : -corridor.offset_m();
  course.middle_left_m = course.wanted_left_m;
  course.half_corridor_m = 0.5 * corridor.width_m();
  course.corridor_sure = corridor.width_known() && corridor.offset_std_m() < kSureOffset_m;
  course.cruise_m_s = cruise_m_s;
  course.left_wall_m = back ? corridor.right_m() : corridor.left_m();
  course.right_wall_m = back ? corridor.left_m() : corridor.right_m();
  return course;
}

TraverseCorridor::TraverseCorridor(const Settings& settings, const RobotDescription& robot)
    : settings_(settings), follower_(settings.driving, robot) {}

void TraverseCorridor::start(const memory::ShortTermMemory& memory) {
  const double off_rad = wrap_angle(memory.pose().heading_rad - memory.corridor().axis_rad());
  if (!failed_) back_ = std::abs(off_rad) > 0.5 * std::numbers::pi;
  failed_ = false;
  follower_.start(memory);
}

Wish TraverseCorridor::tick(const memory::ShortTermMemory& memory) {
  if (settings_.distance_m > 0.0 && follower_.headway_m() >= settings_.distance_m) {
    return final_wish(memory, Progress::succeeded, "the way is made");
  }
  Course course = corridor_course(memory.corridor(), back_, settings_.speed_m_s);
  if (settings_.keep != Keep::middle) {
    const double half_m = 0.5 * memory.corridor().width_m() - settings_.beside_m;
    course.wanted_left_m += settings_.keep == Keep::left ? half_m : -half_m;
  }
  const Wish wish = follower_.tick(memory, course);
  failed_ = wish.progress == Progress::failed;
  return wish;
}

}  // namespace striate::behaviours
