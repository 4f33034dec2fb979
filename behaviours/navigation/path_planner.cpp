#include "striate/behaviours/navigation/path_planner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "striate/base/index_within.hpp"

namespace striate::behaviours {
namespace {

constexpr float kClosed = -1.0F;  // a mark, no price: prices are above 0
constexpr float kInfinite = std::numeric_limits<float>::infinity();
// Prices are those of a metre, in metres of free open floor. By hand (README.md, "Where the numbers
// come from") unless it says otherwise; Planning.* in tests/unit/behaviours holds what they bring
// about.

// Margin beside the flanks that costs nothing (that at which `pace` is full,
// SpeedLimitSettings::roomy_m), and the price at no margin at all.
constexpr double kComfort_m = 0.35;
constexpr double kCrowdingPrice = 5.0;
// Unknown floor is dear; beyond the corridor's width, by more than the corridor's place errs, it is
// hardly a way.
constexpr double kUnknownPrice = 1.4;
constexpr double kOutsidePrice = 6.0;
constexpr double kOutsideTolerance_m = 0.15;
// The edge of seen floor weighs nearly like things, up to SpeedLimitSettings::seen_beside_m.
constexpr double kEdgePrice = 4.0;
constexpr double kEdgeComfort_m = 0.25;
// Between a thing nearer than this and an edge: dearer than all else, so other ways come first.
constexpr double kSqueezePrice = 10.0;
constexpr double kSqueeze_m = 0.15;
// Per square metre off the wanted line; at most a little less than unknown floor costs.
constexpr double kOffLinePrice = 0.30;
constexpr double kOffLineMost = 1.2;
// Times the price within 0.3 m (3 cells) of the way chosen before: Planning.KeepsTheSideItChose.
constexpr double kPathHabit = 0.80;
constexpr int kHabitReach = 3;
// Round the robot nothing is closed, it stands there: its circle about the axle, 0.37 m, in
// patches.
constexpr double kEscape_m = 0.35;
constexpr double kEscapePrice = 8.0;
constexpr double kLeastAdvance_m = 0.45;  // by hand: a way that gets less far is none
// Price that a metre of advance may cost: above unknown floor (2.4), below no margin at all (6).
constexpr float kProgressWorth = 5.0F;
// The root of two to nine digits: a diagonal step. With more digits runs would differ.
constexpr double kDiagonalStep = 1.41421356;

}  // namespace

PathPlanner::PathPlanner() : price_(kNodes), cost_(kNodes), from_(kNodes), chosen_(kNodes) {
  queue_.reserve(static_cast<std::size_t>(kNodes) * 8);
}

double PathPlanner::advance_of(int node) {
  const int along = node / kWide - kBehind;
  return along * kStep_m;
}

Point2 PathPlanner::place_of(int node) const {
  const int aside = node % kWide - kAside;
  return transform(frame_, Point2{advance_of(node), aside * kStep_m});
}

const Path& PathPlanner::plan(const FloorField& field, const Pose2& robot,
                              const PlanRequest& request) {
  frame_ = {robot.x_m, robot.y_m, request.direction_rad};
  mark_last_path();
  price(field, request);
  spread();
  way_.found = false;
  way_.count = 0;
  const int end = best_end();
  if (end >= 0) trace(end, field, request);
  return way_;
}

void PathPlanner::mark_last_path() {
  std::fill(chosen_.begin(), chosen_.end(), std::uint8_t{0});
  if (!way_.found) return;
  for (std::size_t i = 0; i < way_.count; ++i) {
    const Point2 place = inverse_transform(frame_, way_.points[i]);
    const int along = nearest_cell(place.x_m / kStep_m) + kBehind;
    const int aside = nearest_cell(place.y_m / kStep_m) + kAside;
    if (along < 0 || along >= kLong) continue;
    for (int k = std::max(0, aside - kHabitReach); k <= std::min(kWide - 1, aside + kHabitReach);
         ++k) {
      chosen_[static_cast<std::size_t>(along * kWide + k)] = 1;
    }
  }
}

float PathPlanner::price_of(const FloorField& field, const PlanRequest& request, int node) const {
  const Point2 place = place_of(node);
  const Point2 inner{advance_of(node), (node % kWide - kAside) * kStep_m};
  const double margin_m = field.clearance_m(place) - request.half_width_m;
  const memory::CellState state = field.state(place);
  // Beyond a remembered wall unknown is not a way: a blank wall leaves no trace in the map.
  const bool past_wall = inner.y_m > request.left_wall_m - request.half_width_m ||
                         -inner.y_m > request.right_wall_m - request.half_width_m;
  const bool near_robot = std::hypot(inner.x_m, inner.y_m) <= kEscape_m;
  double price = 1.0;
  if (margin_m < request.least_margin_m || (past_wall && state != memory::CellState::free)) {
    if (!near_robot) return kClosed;
    price += kEscapePrice;
  }
  const double crowding = std::clamp(1.0 - margin_m / kComfort_m, 0.0, 1.0);
  price += kCrowdingPrice * crowding * crowding;
  if (state != memory::CellState::free) {
    price += kUnknownPrice;
    // Where the corridor should have ended unknown floor is hardly a way.
    const double out_m = std::abs(inner.y_m - request.middle_left_m) + request.half_width_m -
                         request.half_corridor_m;
    if (out_m > kOutsideTolerance_m) {
      if (request.corridor_sure && !near_robot) return kClosed;
      price += kOutsidePrice;
    }
  }
  // A wall too plain to see shows as the edge of what is known.
  const double edge_m = field.seen_clearance_m(place) - request.half_width_m;
  const double edging = std::clamp(1.0 - edge_m / kEdgeComfort_m, 0.0, 1.0);
  price += kEdgePrice * edging * edging;
  // Between a thing and the edge of knowledge: the room that a plain wall leaves is not known.
  if (margin_m < kSqueeze_m && edge_m < 0.0) price += kSqueezePrice;
  const double off_m = inner.y_m - request.wanted_left_m;
  price += std::min(kOffLineMost, kOffLinePrice * off_m * off_m);
  if (chosen_[static_cast<std::size_t>(node)] != 0) price *= kPathHabit;
  return static_cast<float>(price);
}

void PathPlanner::price(const FloorField& field, const PlanRequest& request) {
  for (int node = 0; node < kNodes; ++node) {
    price_[static_cast<std::size_t>(node)] = price_of(field, request, node);
  }
}

void PathPlanner::relax(int node, float cost, int along, int aside) {
  if (along < 0 || along >= kLong || aside < 0 || aside >= kWide) return;
  const int next = along * kWide + aside;
  const float price = price_[static_cast<std::size_t>(next)];
  if (price < 0.0F) return;
  const bool diagonal = along != node / kWide && aside != node % kWide;
  const auto length_m = static_cast<float>(diagonal ? kStep_m * kDiagonalStep : kStep_m);
  const float total =
      cost + 0.5F * length_m * (price + std::max(0.0F, price_[static_cast<std::size_t>(node)]));
  if (total >= cost_[static_cast<std::size_t>(next)]) return;
  cost_[static_cast<std::size_t>(next)] = total;
  from_[static_cast<std::size_t>(next)] = node;
  queue_.push_back({total, next});
  std::push_heap(queue_.begin(), queue_.end(),
                 [](const Queued& a, const Queued& b) { return a.cost > b.cost; });
}

void PathPlanner::spread() {
  std::fill(cost_.begin(), cost_.end(), kInfinite);
  std::fill(from_.begin(), from_.end(), -1);
  queue_.clear();
  const int start = kBehind * kWide + kAside;
  cost_[static_cast<std::size_t>(start)] = 0.0F;
  queue_.push_back({0.0F, start});
  while (!queue_.empty()) {
    std::pop_heap(queue_.begin(), queue_.end(),
                  [](const Queued& a, const Queued& b) { return a.cost > b.cost; });
    const Queued top = queue_.back();
    queue_.pop_back();
    if (top.cost > cost_[static_cast<std::size_t>(top.node)]) continue;
    const int along = top.node / kWide;
    const int aside = top.node % kWide;
    for (int da = -1; da <= 1; ++da) {
      for (int ds = -1; ds <= 1; ++ds) {
        if (da != 0 || ds != 0) relax(top.node, top.cost, along + da, aside + ds);
      }
    }
  }
}

int PathPlanner::best_end() const {
  int best = -1;
  float least = kInfinite;
  for (int node = 0; node < kNodes; ++node) {
    const float cost = cost_[static_cast<std::size_t>(node)];
    const double advance_m = advance_of(node);
    if (cost == kInfinite || advance_m < kLeastAdvance_m) continue;
    const float score = cost - kProgressWorth * static_cast<float>(advance_m);
    if (score < least) {
      least = score;
      best = node;
    }
  }
  return best;
}

void PathPlanner::trace(int end, const FloorField& field, const PlanRequest& request) {
  std::size_t length = 0;
  for (int node = end; node >= 0; node = from_[static_cast<std::size_t>(node)]) ++length;
  way_.count = std::min(length, Path::kCapacity);
  way_.found = true;
  way_.progress_m = advance_of(end);
  way_.reaches_far = end / kWide == kLong - 1;
  way_.least_margin_m = FloorField::kFar_m;
  std::size_t at = length;
  for (int node = end; node >= 0; node = from_[static_cast<std::size_t>(node)]) {
    --at;
    if (at >= Path::kCapacity) continue;
    way_.points[at] = place_of(node);
    way_.least_margin_m =
        std::min(way_.least_margin_m, field.clearance_m(way_.points[at]) - request.half_width_m);
  }
}

}  // namespace striate::behaviours
