#include "striate/behaviours/navigation/behind.hpp"

namespace striate::behaviours {
namespace {

constexpr double kReach_m = 1.0;     // by hand (README.md): more than any behaviour backs at once
constexpr double kBeside_m = 0.025;  // half a patch: a way driven over is not wider than the robot
constexpr int kAcross = 8;           // samples: 0.047 m apart, less than a patch
constexpr int kHole = 1;             // of the samples across: a column without a match

bool row_is_free(const memory::ShortTermMemory& memory, double behind_m, double half_width_m) {
  int unknown = 0;
  for (int i = 0; i <= kAcross; ++i) {
    const double left_m = half_width_m * (2.0 * i / kAcross - 1.0);
    const Point2 place = transform(memory.pose(), Point2{-behind_m, left_m});
    const memory::CellState state = memory.map().state(memory::LocalGrid::cell_of(place));
    if (state == memory::CellState::occupied) return false;
    unknown += state == memory::CellState::unknown;
  }
  return unknown <= kHole;
}

}  // namespace

double free_behind_m(const memory::ShortTermMemory& memory, const RobotDescription& robot) {
  const double half_width_m = robot.half_width_m - kBeside_m;
  double free_m = 0.0;
  for (double s = memory::LocalGrid::kCell_m; s <= kReach_m + 1e-9;
       s += memory::LocalGrid::kCell_m) {
    if (!row_is_free(memory, robot.rear_m + s, half_width_m)) break;
    free_m = s;
  }
  return free_m;
}

}  // namespace striate::behaviours
