#include "striate/perception/motion/motion.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "striate/perception/motion/carried_back.hpp"
#include "striate/perception/motion/place_verdict.hpp"
#include "striate/perception/motion/velocity.hpp"

namespace striate::perception {
namespace {

/// Judged pixels that a column's share needs: as many as an obstacle (smallest_px)
constexpr int kFewestPixels = 8;
/// Confidence of what looks like nothing before: for and against (ours)
constexpr double kUnexplained = 0.5;
/// Share of what was judged, of things that nothing before looks like (ours; see motion_table)
constexpr double kMostlyCame = 0.85;
constexpr double kWide = 1.5;  ///< times the narrowest: a torso where that is a leg (ours)
/// Columns to either side that are judged together, as column_scan.cpp pools
constexpr int kPool = 2;
/// Pixels this near to the column's obstacle are it: a person's depth (ours) ...
constexpr double kSameThing_m = 0.3;
/// ... or by this share of its distance; one px of disparity 3 m away
constexpr double kSameThing = 0.12;

bool belongs(const SpacePoint& p, const Column& column) {
  const double range_m = std::hypot(p.x_m, p.y_m);
  return std::abs(range_m - column.obstacle_m) <=
         std::max(kSameThing_m, kSameThing * column.obstacle_m);
}

/// Calls `use(v, point)` for the trusted pixels of a column that show its obstacle.
template <class Use>
void for_each_pixel(const DisparityMap& map, const ViewGeometry& geometry, const Column& column,
                    int u, const MotionSettings& s, const Use& use) {
  if (!std::isfinite(column.obstacle_m)) return;
  for (int v = 0; v < map.disparity_px.rows; ++v) {
    const float d = map.disparity_px(v, u);
    if (!std::isfinite(d) || d <= 0.0F || map.confidence(v, u) < s.trusted) continue;
    const SpacePoint p = geometry.point(u, v, d);
    if (p.z_m >= s.lowest_m && p.z_m <= s.highest_m && belongs(p, column)) use(v, p);
  }
}

bool one_thing(const Column& a, const Column& b) {
  return std::abs(a.obstacle_m - b.obstacle_m) <= std::max(kSameThing_m, kSameThing * a.obstacle_m);
}

}  // namespace

struct MotionFinder::Comparison {
  const MotionView& now;
  const Kept& before;
  CarriedBack carried;
};

void MotionFinder::find(const MotionView& now, std::vector<Column>& columns,
                        std::vector<MovingThing>& moving) {
  moving.clear();
  const Kept* before = image_before(now.stamp);
  const bool fits = before != nullptr && before->grey.size() == now.grey.size() &&
                    columns.size() == static_cast<std::size_t>(now.grey.cols);
  if (fits) {
    const ViewGeometry geometry(*now.disparity, now.head, robot_);
    const ViewGeometry geometry_before(before->disparity, before->head, robot_);
    const Comparison pair{now, *before,
                          CarriedBack({geometry, now.base}, {geometry_before, before->base})};
    judge_columns(pair, columns);
    list_things(pair, columns, moving);
  }
  keep(now);
}

void MotionFinder::keep(const MotionView& now) {
  Kept& place = kept_[next_];
  next_ = (next_ + 1) % kept_.size();
  place.stamp = now.stamp;
  place.head = now.head;
  place.base = now.base;
  now.grey.copyTo(place.grey);
  now.disparity->disparity_px.copyTo(place.disparity.disparity_px);
  now.disparity->confidence.copyTo(place.disparity.confidence);
  place.disparity.focal_px = now.disparity->focal_px;
  place.disparity.centre_u_px = now.disparity->centre_u_px;
  place.disparity.centre_v_px = now.disparity->centre_v_px;
  place.disparity.baseline_m = now.disparity->baseline_m;
  place.used = true;
}

/// The kept image whose age is nearest to the gap, between half of it and twice.
const MotionFinder::Kept* MotionFinder::image_before(TimePoint now) const {
  const Kept* best = nullptr;
  double least = 0.0;
  for (const Kept& kept : kept_) {
    const double age_s = to_seconds(now - kept.stamp);
    if (!kept.used || age_s < 0.5 * settings_.gap_s || age_s > 2.0 * settings_.gap_s) continue;
    const double off = std::abs(age_s - settings_.gap_s);
    if (best == nullptr || off < least) {
      best = &kept;
      least = off;
    }
  }
  return best;
}

void MotionFinder::judge_columns(const Comparison& pair, std::vector<Column>& columns) {
  const int width = pair.now.grey.cols;
  const SeenMaps maps{*pair.now.disparity, pair.before.disparity,
                      to_seconds(pair.now.stamp - pair.before.stamp)};
  moved_.assign(columns.size(), 0);
  came_.assign(columns.size(), 0);
  stayed_.assign(columns.size(), 0);
  for (int u = 0; u < width; ++u) {
    const auto judge = [&](int, const SpacePoint& p) {
      const Verdict verdict = judge_point(p, pair.carried, maps, settings_);
      came_[u] += verdict == Verdict::came;
      moved_[u] += verdict == Verdict::came || verdict == Verdict::went;
      stayed_[u] += verdict == Verdict::stayed;
    };
    for_each_pixel(*pair.now.disparity, pair.carried.now(), columns[u], u, settings_, judge);
  }
  for (int u = 0; u < width; ++u) {
    int moved = 0;
    int judged = 0;
    for (int n = std::max(0, u - kPool); n <= std::min(width - 1, u + kPool); ++n) {
      if (!one_thing(columns[u], columns[n])) continue;
      moved += moved_[n];
      judged += moved_[n] + stayed_[n];
    }
    columns[u].moving = judged >= kFewestPixels ? static_cast<double>(moved) / judged : 0.0;
  }
}

MovingThing MotionFinder::describe(const Comparison& pair, const std::vector<Column>& columns,
                                   int from, int to) const {
  MovingThing thing;
  std::vector<ThingPixel> pixels;
  thing.distance_m = kNothing_m;
  for (int u = from; u <= to; ++u) {
    thing.distance_m = std::min(thing.distance_m, columns[u].obstacle_m);
    thing.confidence += columns[u].moving * columns[u].obstacle_confidence / (to - from + 1);
    for_each_pixel(*pair.now.disparity, pair.carried.now(), columns[u], u, settings_,
                   [&](int v, const SpacePoint& p) {
                     pixels.push_back({u, v, p});
                   });
  }
  thing.bearing_rad = columns[(from + to) / 2].bearing_rad;
  thing.width_m = thing.distance_m * std::abs(columns[from].bearing_rad - columns[to].bearing_rad);
  thing.from_u_px = from;
  thing.to_u_px = to;
  const EarlierView earlier{pair.before.grey, pair.before.disparity,
                            to_seconds(pair.now.stamp - pair.before.stamp)};
  const std::optional<Point2> velocity =
      find_velocity(pixels, pair.now.grey, pair.carried, earlier, settings_.fastest_m_s);
  thing.velocity_known = velocity.has_value();
  if (!velocity) thing.confidence *= kUnexplained;
  if (velocity) thing.forward_m_s = velocity->x_m, thing.left_m_s = velocity->y_m;
  return thing;
}

/// Whether the thing moves indeed. What looks as it did where it is now stands: its disparity
/// erred. Where its look is not found again at all, it must have come where nothing was: what was
/// hidden by something that left comes into sight, too, but by going.
bool MotionFinder::is_sure(const MovingThing& thing) const {
  const int columns = thing.to_u_px - thing.from_u_px + 1;
  if (columns < settings_.narrowest_px) return false;
  if (thing.velocity_known) {
    return std::hypot(thing.forward_m_s, thing.left_m_s) >= settings_.slowest_m_s;
  }
  int came = 0;
  int judged = 0;
  for (int u = thing.from_u_px; u <= thing.to_u_px; ++u) {
    came += came_[u];
    judged += moved_[u] + stayed_[u];
  }
  return columns >= kWide * settings_.narrowest_px && came >= kMostlyCame * judged;
}

void MotionFinder::list_things(const Comparison& pair, std::vector<Column>& columns,
                               std::vector<MovingThing>& moving) const {
  const int width = static_cast<int>(columns.size());
  const auto moves = [&](int u) { return columns[u].moving >= settings_.least_share; };
  for (int from = 0; from < width; ++from) {
    if (!moves(from)) continue;
    int to = from;
    while (to + 1 < width && moves(to + 1) && one_thing(columns[to], columns[to + 1])) ++to;
    const MovingThing thing = describe(pair, columns, from, to);
    if (is_sure(thing)) {
      moving.push_back(thing);
    } else {
      for (int u = from; u <= to; ++u) columns[u].moving = 0.0;
    }
    from = to;
  }
  std::stable_sort(moving.begin(), moving.end(),
                   [](const auto& a, const auto& b) { return a.distance_m < b.distance_m; });
}

}  // namespace striate::perception
