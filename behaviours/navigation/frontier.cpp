#include "striate/behaviours/navigation/frontier.hpp"

#include <algorithm>
#include <cmath>

#include "striate/base/index_within.hpp"

namespace striate::behaviours {
namespace {

// "By hand": README.md, "Where the numbers come from"; the mission is config/tasks/explore.yaml.

constexpr double kMargin_m = 0.08;  // by hand: beside the flanks, as at the slowest pace
// Round the robot nothing is closed, it stands there: its circle about the axle, 0.37 m, and
// margin.
constexpr double kUnderRobot_m = 0.45;
// By hand: what is looked at round a frontier, so densely, and how much of it must be unknown: nine
// of 81 samples.
constexpr double kRound_m = 0.6;
constexpr double kSample_m = 0.15;
constexpr double kLeastUnknown_m2 = 0.20;
constexpr double kSeeThrough_m = 0.08;  // by hand: floor halfway must be so far from things
// By hand: worth of unknown floor, price of the way and of the turning; one square metre is worth
// eight metres of way.
constexpr double kWorth_per_m2 = 4.0;
constexpr double kPathPrice_per_m = 0.5;
constexpr double kTurnPrice_per_rad = 0.5;
// By hand: what the last choice is given, and how near to it is the same: as much as 1.6 m of way.
constexpr double kHabit = 0.8;
constexpr double kHabit_m = 0.8;
constexpr double kAvoided_m = 0.7;   // by hand: round a place that was given up; more than kRound_m
constexpr double kNext_m = 1.5;      // by hand: the point that is steered for, of the way there
constexpr double kLeastWay_m = 0.3;  // by hand: three squares; nearer, there is no way
// The root of two to nine digits: a diagonal step. With more digits runs would differ.
constexpr double kDiagonal = 1.41421356;

}  // namespace

std::size_t KnownFloor::index(Point2 odometry) {
  const auto square = [](double metres) {
    return static_cast<std::size_t>(cell_below(metres / kSquare_m) & (kSide - 1));
  };
  return square(odometry.y_m) * kSide + square(odometry.x_m);
}

FrontierFinder::FrontierFinder(const RobotDescription& robot)
    : half_width_m_(robot.half_width_m),
      way_m_(static_cast<std::size_t>(kSide) * kSide),
      from_(static_cast<std::size_t>(kSide) * kSide) {
  queue_.reserve(static_cast<std::size_t>(kSide) * kSide);
}

void FrontierFinder::forget() {
  known_.forget();
  avoided_count_ = 0;
  preferred_ = {1e9, 1e9};
}

Point2 FrontierFinder::place_of(int node) const {
  return {middle_.x_m + (node % kSide - kReach) * kStep_m,
          middle_.y_m + (node / kSide - kReach) * kStep_m};
}

void FrontierFinder::note(const FloorField& field, const Pose2& robot) {
  middle_ = {robot.x_m, robot.y_m};
  for (int node = 0; node < kSide * kSide; ++node) {
    const Point2 place = place_of(node);
    // Too near to a thing to be driven on: as good as known.
    const bool shut = field.clearance_m(place) < half_width_m_;
    if (shut || field.state(place) != memory::CellState::unknown) known_.know(place);
  }
}

bool FrontierFinder::open(const FloorField& field, Point2 place, const Pose2& robot) const {
  if (apart_m(place, {robot.x_m, robot.y_m}) < kUnderRobot_m) return true;
  if (field.clearance_m(place) < half_width_m_ + kMargin_m) return false;
  return field.state(place) == memory::CellState::free || known_.knows(place);
}

void FrontierFinder::spread(const FloorField& field, const Pose2& robot) {
  std::fill(way_m_.begin(), way_m_.end(), -1.0F);
  queue_.clear();
  const int start = kReach * kSide + kReach;
  way_m_[static_cast<std::size_t>(start)] = 0.0F;
  from_[static_cast<std::size_t>(start)] = -1;
  queue_.push_back(start);
  // The eight squares round one, by their number; the four straight ones first.
  constexpr std::array<int, 8> kNeighbours{1,         -1,        kSide,      -kSide,
                                           kSide + 1, kSide - 1, -kSide + 1, -kSide - 1};
  for (std::size_t head = 0; head < queue_.size(); ++head) {
    const int node = queue_[head];
    const int column = node % kSide;
    const int row = node / kSide;
    if (column == 0 || row == 0 || column == kSide - 1 || row == kSide - 1) continue;
    for (std::size_t k = 0; k < kNeighbours.size(); ++k) {
      const int next = node + kNeighbours[k];
      if (way_m_[static_cast<std::size_t>(next)] >= 0.0F) continue;
      if (!open(field, place_of(next), robot)) continue;
      const auto step_m = static_cast<float>(k < 4 ? kStep_m : kDiagonal * kStep_m);
      way_m_[static_cast<std::size_t>(next)] = way_m_[static_cast<std::size_t>(node)] + step_m;
      from_[static_cast<std::size_t>(next)] = node;
      queue_.push_back(next);
    }
  }
}

/// Slivers beside things do not count, no robot fits there; nor what lies behind them.
double FrontierFinder::unknown_round_m2(const FloorField& field, Point2 place) const {
  int unknown = 0;
  for (double y = -kRound_m; y <= kRound_m; y += kSample_m) {
    for (double x = -kRound_m; x <= kRound_m; x += kSample_m) {
      const Point2 at{place.x_m + x, place.y_m + y};
      const Point2 between{place.x_m + 0.5 * x, place.y_m + 0.5 * y};
      unknown += field.state(at) == memory::CellState::unknown && !known_.knows(at) &&
                 field.clearance_m(at) > half_width_m_ &&
                 field.clearance_m(between) > kSeeThrough_m;
    }
  }
  return unknown * kSample_m * kSample_m;
}

bool FrontierFinder::avoided(Point2 place) const {
  return std::any_of(avoided_.begin(),
                     avoided_.begin() + static_cast<std::ptrdiff_t>(avoided_count_),
                     [place](Point2 other) { return apart_m(place, other) < kAvoided_m; });
}

void FrontierFinder::avoid(Point2 place) {
  avoided_[avoided_count_ % kAvoided] = place;
  avoided_count_ = std::min(avoided_count_ + 1, kAvoided);
}

Frontier FrontierFinder::find(const FloorField& field, const Pose2& robot) {
  middle_ = {robot.x_m, robot.y_m};
  spread(field, robot);
  Frontier best;
  double best_worth = -1e9;
  int best_node = -1;
  for (const int node : queue_) {
    const double way_m = way_m_[static_cast<std::size_t>(node)];
    if (way_m < kLeastWay_m || node % 2 != 0) continue;  // every other square is enough
    const Point2 place = place_of(node);
    const double unknown_m2 = unknown_round_m2(field, place);
    if (unknown_m2 < kLeastUnknown_m2 || avoided(place)) continue;
    const Point2 inner = inverse_transform(robot, place);
    const double turn_rad = std::abs(std::atan2(inner.y_m, inner.x_m));
    double worth =
        kWorth_per_m2 * unknown_m2 - kPathPrice_per_m * way_m - kTurnPrice_per_rad * turn_rad;
    if (apart_m(place, preferred_) < kHabit_m) worth += kHabit;
    if (worth <= best_worth) continue;
    best_worth = worth;
    best_node = node;
    best = {true, place, place, way_m, unknown_m2};
  }
  if (best.found) best.next = next_on_path(best_node);
  return best;
}

Point2 FrontierFinder::next_on_path(int node) const {
  int at = node;
  while (way_m_[static_cast<std::size_t>(at)] > kNext_m) at = from_[static_cast<std::size_t>(at)];
  return place_of(at);
}

}  // namespace striate::behaviours
