#include "striate/platform/simulator/passage.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "striate/platform/simulator/corridor_width.hpp"
#include "striate/platform/simulator/obstacle_shapes.hpp"
#include "striate/platform/simulator/shapes.hpp"
#include "striate/platform/simulator/static_shapes.hpp"

// A disc is held up when the things, grown by its radius, part start and goal: when they join to a
// closed ring round one of the two. So things are joined in the order of the gaps between them, and
// the gap that closes the first such ring is how wide the way is. A ring lies round one of the two
// when it crosses the line between them an odd number of times.
namespace striate::simulator {
namespace {

/// Where beyond the goal line the way may end: places so far apart, a tenth of the robot's width.
constexpr double kGoalStep_m = 0.05;
/// So far beyond the goal line they lie: the line itself is not beyond.
constexpr double kJustBeyond_m = 0.01;

/// The gap between two things, and the nearest points of their cores.
struct Gap {
  double width_m = std::numeric_limits<double>::infinity();
  Point2 on_one;
  Point2 on_other;
};

std::size_t edges_of(const ConvexShape& shape) {
  return shape.corners.size() < 3 ? 1 : shape.corners.size();
}

struct Edge {
  Point2 from;
  Point2 to;
};
Edge edge_of(const ConvexShape& shape, std::size_t i) {
  return {shape.corners[i], shape.corners[(i + 1) % shape.corners.size()]};
}

bool covers(const ConvexShape& shape, Point2 place) {
  return shape.corners.size() >= 3 && inside_polygon(place, shape.corners);
}

/// Where two edges that cross meet.
Point2 meeting_point(const Edge& a, const Edge& b) {
  const double ax = a.to.x_m - a.from.x_m, ay = a.to.y_m - a.from.y_m;
  const double bx = b.to.x_m - b.from.x_m, by = b.to.y_m - b.from.y_m;
  const double area = ax * by - ay * bx;
  if (area == 0.0) return a.from;
  const double t = ((b.from.x_m - a.from.x_m) * by - (b.from.y_m - a.from.y_m) * bx) / area;
  return {a.from.x_m + t * ax, a.from.y_m + t * ay};
}

void keep_nearer(Gap& best, double grown_m, Point2 on_one, Point2 on_other) {
  const double width = std::max(0.0, distance_m(on_one, on_other) - grown_m);
  if (width < best.width_m) best = {width, on_one, on_other};
}

Gap gap_between(const ConvexShape& one, const ConvexShape& other) {
  if (covers(one, other.corners[0])) return {0.0, other.corners[0], other.corners[0]};
  if (covers(other, one.corners[0])) return {0.0, one.corners[0], one.corners[0]};
  Gap best;
  const double grown = one.radius_m + other.radius_m;
  for (std::size_t i = 0; i < edges_of(one); ++i) {
    const Edge a = edge_of(one, i);
    for (std::size_t j = 0; j < edges_of(other); ++j) {
      const Edge b = edge_of(other, j);
      if (segments_cross(a.from, a.to, b.from, b.to)) {
        const Point2 both = meeting_point(a, b);
        return {0.0, both, both};
      }
      for (const Point2 end : {a.from, a.to}) {
        keep_nearer(best, grown, end, nearest_on_segment(end, b.from, b.to));
      }
      for (const Point2 end : {b.from, b.to}) {
        keep_nearer(best, grown, nearest_on_segment(end, a.from, a.to), end);
      }
    }
  }
  return best;
}

double side_of(Point2 from, Point2 to, Point2 place) {
  return (to.x_m - from.x_m) * (place.y_m - from.y_m) -
         (to.y_m - from.y_m) * (place.x_m - from.x_m);
}

/// Half-open, so that a way with a corner on the line crosses it once.
bool crosses(const Edge& way, const Edge& line) {
  return (side_of(line.from, line.to, way.from) >= 0.0) !=
             (side_of(line.from, line.to, way.to) >= 0.0) &&
         (side_of(way.from, way.to, line.from) >= 0.0) !=
             (side_of(way.from, way.to, line.to) >= 0.0);
}

/// Things joined, each with whether the way to its group's first one crosses the line.
class JoinedThings {
 public:
  explicit JoinedThings(std::size_t count) : parent_(count), odd_(count, 0) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  /// Joins two by a way that crosses the line or not; true where that closes an odd ring.
  bool closes_odd_ring(std::size_t a, std::size_t b, bool crossing) {
    const auto [root_a, odd_a] = root_of(a);
    const auto [root_b, odd_b] = root_of(b);
    const bool odd = odd_a != (odd_b != crossing);
    if (root_a == root_b) return odd;
    parent_[root_a] = root_b;
    odd_[root_a] = odd ? 1 : 0;
    return false;
  }

 private:
  [[nodiscard]] std::pair<std::size_t, bool> root_of(std::size_t thing) const {
    bool odd = false;
    while (parent_[thing] != thing) {
      odd = odd != (odd_[thing] != 0);
      thing = parent_[thing];
    }
    return {thing, odd};
  }
  std::vector<std::size_t> parent_;
  std::vector<char> odd_;
};

struct Joint {
  std::size_t one = 0;
  std::size_t other = 0;
  Gap gap;
};

std::vector<StaticShape> everything(const World& world, const FloorPlan& plan) {
  std::vector<StaticShape> things = standing_shapes(world, plan);
  for (StaticShape& wall : wall_shapes(plan)) things.push_back(std::move(wall));
  for (const Stander& stander : world.standers) {
    const Pose2 at = plan.at(stander.at.x_m, stander.at.y_m);
    const Point2 place{at.x_m, at.y_m};
    things.push_back({"person", disc(place, kPersonRadius_m), place, kPersonRadius_m});
  }
  return things;
}

std::vector<Joint> joints_between(const std::vector<StaticShape>& things) {
  std::vector<Joint> joints;
  joints.reserve(things.size() * things.size() / 2);
  for (std::size_t i = 0; i < things.size(); ++i) {
    for (std::size_t j = i + 1; j < things.size(); ++j) {
      joints.push_back({i, j, gap_between(things[i].shape, things[j].shape)});
    }
  }
  std::stable_sort(joints.begin(), joints.end(),
                   [](const Joint& a, const Joint& b) { return a.gap.width_m < b.gap.width_m; });
  return joints;
}

/// The widest disc that has room at a place, and between what.
Passage room_at(Point2 place, const std::vector<StaticShape>& things) {
  Passage room{std::numeric_limits<double>::infinity(), place, "", ""};
  for (const StaticShape& thing : things) {
    const double width = 2.0 * distance_m(disc(place, 0.0), thing.shape);
    if (width < room.width_m) room = {width, place, thing.name, thing.name};
  }
  return room;
}

Passage between(const Edge& line, const std::vector<StaticShape>& things,
                const std::vector<Joint>& joints) {
  JoinedThings joined(things.size());
  for (const Joint& joint : joints) {
    const StaticShape& one = things[joint.one];
    const StaticShape& other = things[joint.other];
    const Gap& gap = joint.gap;
    const bool odd =
        crosses({one.middle, gap.on_one}, line) !=
        (crosses({gap.on_one, gap.on_other}, line) != crosses({gap.on_other, other.middle}, line));
    if (!joined.closes_odd_ring(joint.one, joint.other, odd)) continue;
    const Point2 middle{(gap.on_one.x_m + gap.on_other.x_m) / 2,
                        (gap.on_one.y_m + gap.on_other.y_m) / 2};
    return {gap.width_m, middle, one.name, other.name};
  }
  return {std::numeric_limits<double>::infinity(), line.to, "", ""};
}

}  // namespace

Passage widest_passage(const World& world, const FloorPlan& plan) {
  const std::vector<StaticShape> things = everything(world, plan);
  const std::vector<Joint> joints = joints_between(things);
  const Pose2 from = plan.at(world.start.x_m, world.start.y_m);
  const Point2 start{from.x_m, from.y_m};
  const Passage at_start = room_at(start, things);
  Passage best;
  const double along = world.goal_beyond_m + kJustBeyond_m;
  const double half = half_width_m(world, along);
  for (double left = kGoalStep_m - half; left < half; left += kGoalStep_m) {
    const Pose2 to = plan.at(along, left);
    const Passage at_goal = room_at({to.x_m, to.y_m}, things);
    if (at_goal.width_m <= best.width_m) continue;
    Passage way = between({start, {to.x_m, to.y_m}}, things, joints);
    if (at_goal.width_m < way.width_m) way = at_goal;
    if (at_start.width_m < way.width_m) way = at_start;
    if (way.width_m > best.width_m) best = way;
  }
  return best;
}

}  // namespace striate::simulator
