#include "striate/platform/simulator/clearance_map.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace striate::simulator {
namespace {

constexpr double kCell_m =
    0.1;  // a fifth of a person's width: no gap that one fits through is lost
/// People need no finer answer than "more than this".
constexpr double kFar_m = 1.5;  // people need no finer answer than "more than this": six radii
/// The string is pulled tight over this many cells at a time: long ways stay cheap.
/// The string is pulled tight over so many cells, 8 m, at a time: long ways stay cheap (ours)
constexpr std::size_t kPullCells = 80;

}  // namespace

ClearanceMap::ClearanceMap(const World& world, const FloorPlan& plan) {
  Point2 low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  Point2 high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};
  for (const Point2& corner : plan.outline) {
    low = {std::min(low.x_m, corner.x_m), std::min(low.y_m, corner.y_m)};
    high = {std::max(high.x_m, corner.x_m), std::max(high.y_m, corner.y_m)};
  }
  origin_ = {low.x_m - kCell_m, low.y_m - kCell_m};
  columns_ = static_cast<int>(std::ceil((high.x_m - origin_.x_m) / kCell_m)) + 2;
  rows_ = static_cast<int>(std::ceil((high.y_m - origin_.y_m) / kCell_m)) + 2;
  fill(world, plan);
}

void ClearanceMap::fill(const World& world, const FloorPlan& plan) {
  std::vector<StaticShape> things = standing_shapes(world, plan);
  for (StaticShape& wall : wall_shapes(plan)) things.push_back(std::move(wall));
  clearance_m_.assign(static_cast<std::size_t>(columns_ * rows_), static_cast<float>(kFar_m));
  // Each thing touches only the cells near it.
  for (const StaticShape& thing : things) {
    Point2 low = thing.shape.corners.front();
    Point2 high = low;
    for (const Point2& corner : thing.shape.corners) {
      low = {std::min(low.x_m, corner.x_m), std::min(low.y_m, corner.y_m)};
      high = {std::max(high.x_m, corner.x_m), std::max(high.y_m, corner.y_m)};
    }
    const double reach = kFar_m + thing.shape.radius_m;
    const auto cell = [](double value, double origin, int count) {
      return std::clamp(static_cast<int>(std::floor((value - origin) / kCell_m)), 0, count - 1);
    };
    const int column_end = cell(high.x_m + reach, origin_.x_m, columns_);
    const int row_end = cell(high.y_m + reach, origin_.y_m, rows_);
    for (int row = cell(low.y_m - reach, origin_.y_m, rows_); row <= row_end; ++row) {
      for (int column = cell(low.x_m - reach, origin_.x_m, columns_); column <= column_end;
           ++column) {
        float& value = clearance_m_[static_cast<std::size_t>(row * columns_ + column)];
        const Point2 place = place_of(row * columns_ + column);
        value = std::min(value, static_cast<float>(distance_m(thing.shape, disc(place, 0.0))));
      }
    }
  }
  for (int i = 0; i < columns_ * rows_; ++i) {
    if (!inside_polygon(place_of(i), plan.outline)) clearance_m_[static_cast<std::size_t>(i)] = 0;
  }
}

Point2 ClearanceMap::place_of(int cell) const {
  const int column = cell % columns_, row = cell / columns_;
  return {origin_.x_m + kCell_m * column, origin_.y_m + kCell_m * row};
}

int ClearanceMap::cell_at(Point2 place) const {
  const int column = std::clamp(static_cast<int>(std::lround((place.x_m - origin_.x_m) / kCell_m)),
                                0, columns_ - 1);
  const int row =
      std::clamp(static_cast<int>(std::lround((place.y_m - origin_.y_m) / kCell_m)), 0, rows_ - 1);
  return row * columns_ + column;
}

double ClearanceMap::at(Point2 place) const {
  const double x = (place.x_m - origin_.x_m) / kCell_m;
  const double y = (place.y_m - origin_.y_m) / kCell_m;
  const int column = static_cast<int>(std::floor(x));
  const int row = static_cast<int>(std::floor(y));
  if (column < 0 || row < 0 || column + 1 >= columns_ || row + 1 >= rows_) return 0.0;
  const double fx = x - column;
  const double fy = y - row;
  const float* cell = &clearance_m_[static_cast<std::size_t>(row * columns_ + column)];
  return (1 - fy) * ((1 - fx) * cell[0] + fx * cell[1]) +
         fy * ((1 - fx) * cell[columns_] + fx * cell[columns_ + 1]);
}

bool ClearanceMap::straight_is_free(Point2 from, Point2 to, double radius_m) const {
  const int steps = 1 + static_cast<int>(distance_m(from, to) / (kCell_m / 2));
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    if (at({from.x_m + t * (to.x_m - from.x_m), from.y_m + t * (to.y_m - from.y_m)}) < radius_m) {
      return false;
    }
  }
  return true;
}

std::vector<int> ClearanceMap::cells_on_path(int from, int to, double radius_m) const {
  // A* over the eight neighbours.
  const std::size_t count = clearance_m_.size();
  std::vector<float> cost(count, std::numeric_limits<float>::infinity());
  std::vector<int> came_from(count, -1);
  using Entry = std::pair<float, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const Point2 goal = place_of(to);
  cost[static_cast<std::size_t>(from)] = 0.0F;
  open.emplace(0.0F, from);
  while (!open.empty()) {
    const auto [estimate, cell] = open.top();
    open.pop();
    if (cell == to) break;
    const float so_far = cost[static_cast<std::size_t>(cell)];
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const int column = cell % columns_ + dx;
        const int row = cell / columns_ + dy;
        if (column < 0 || row < 0 || column >= columns_ || row >= rows_) continue;
        const int next = row * columns_ + column;
        const auto index = static_cast<std::size_t>(next);
        if (clearance_m_[index] < radius_m && next != to) continue;
        const float through = so_far + static_cast<float>(kCell_m * std::hypot(dx, dy));
        if (through >= cost[index]) continue;
        cost[index] = through;
        came_from[index] = cell;
        open.emplace(through + static_cast<float>(distance_m(place_of(next), goal)), next);
      }
    }
  }
  std::vector<int> cells;
  if (came_from[static_cast<std::size_t>(to)] < 0) return cells;
  for (int cell = to; cell >= 0; cell = came_from[static_cast<std::size_t>(cell)]) {
    cells.push_back(cell);
  }
  std::reverse(cells.begin(), cells.end());
  return cells;
}

std::optional<std::vector<Point2>> ClearanceMap::way(Point2 from, Point2 to,
                                                     double radius_m) const {
  if (straight_is_free(from, to, radius_m)) return std::vector<Point2>{from, to};
  std::vector<Point2> raw;
  for (const int cell : cells_on_path(cell_at(from), cell_at(to), radius_m)) {
    raw.push_back(place_of(cell));
  }
  if (raw.size() < 2) return std::nullopt;
  raw.front() = from;
  raw.back() = to;
  // Pull the string tight: keep only the corners that are needed.
  std::vector<Point2> corners{from};
  std::size_t here = 0;
  while (here + 1 < raw.size()) {
    std::size_t next = here + 1;
    for (std::size_t far = std::min(raw.size() - 1, here + kPullCells); far > here + 1; --far) {
      if (straight_is_free(raw[here], raw[far], radius_m - 0.02)) {
        next = far;
        break;
      }
    }
    corners.push_back(raw[next]);
    here = next;
  }
  return corners;
}

}  // namespace striate::simulator
