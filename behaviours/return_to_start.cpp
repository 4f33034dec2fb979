#include "striate/behaviours/return_to_start.hpp"

#include "striate/behaviours/control/short_format.hpp"

namespace striate::behaviours {
namespace {

/// Landmarks seen on the way correct where the start is; without a memory odometry alone says it.
Point2 start_of(const memory::ShortTermMemory& memory) {
  const Pose2 start =
      memory.place().active() ? memory.place().start() : memory.trajectory().start();
  return {start.x_m, start.y_m};
}

}  // namespace

// The first heading is the corridor's axis: TurnTo's heading 0.
ReturnToStart::ReturnToStart(const Settings& settings, const RobotDescription& robot)
    : settings_(settings), journey_(settings.driving, robot), turn_(TurnTo::Settings{}, robot) {}

void ReturnToStart::start(const memory::ShortTermMemory& memory) {
  there_ = false;
  journey_.start(memory);
}

Wish ReturnToStart::tick(const memory::ShortTermMemory& memory) {
  if (there_) return turn_.tick(memory);
  const Point2 home = start_of(memory);
  const double left_m = distance_to_m(memory, home);
  if (left_m <= settings_.within_m) {
    if (!settings_.facing) return final_wish(memory, Progress::succeeded, "back at the start");
    there_ = true;
    turn_.start(memory);
    return turn_.tick(memory);
  }
  Wish wish = journey_.tick(memory, home, settings_.speed_m_s);
  if (wish.progress == Progress::running && wish.why.view() == "drives on") {
    wish.why = short_format("drives back, {:.1f} m from the start", left_m);
  }
  return wish;
}

}  // namespace striate::behaviours
