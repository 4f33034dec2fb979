#include <algorithm>
#include <cmath>
#include <limits>

#include "striate/platform/simulator/corridor_width.hpp"
#include "striate/platform/simulator/scene.hpp"
#include "striate/platform/simulator/shapes.hpp"

namespace striate::simulator {
namespace {

/// A straight part of the centre line.
struct Leg {
  Pose2 start;
  double length_m = 0.0;
};

std::vector<Leg> legs_of(const std::vector<Point2>& centre_line) {
  std::vector<Leg> legs;
  for (std::size_t i = 0; i + 1 < centre_line.size(); ++i) {
    const Point2& a = centre_line[i];
    const Point2& b = centre_line[i + 1];
    legs.push_back({{a.x_m, a.y_m, std::atan2(b.y_m - a.y_m, b.x_m - a.x_m)}, distance_m(a, b)});
  }
  return legs;
}

/// A straight piece of a side wall in corridor coordinates.
struct Piece {
  std::size_t leg = 0;
  double from_m = 0.0;
  double to_m = 0.0;
  double left_m = 0.0;
  std::string material;
};

class PlanBuilder {
 public:
  explicit PlanBuilder(const World& world) : world_(world) {
    plan_.height_m = world.height_m;
    lay_centre_line();
  }

  FloorPlan build() {
    // Counter-clockwise: along the right wall, across the end, back along the left wall.
    add_side(pieces_of(Side::right), Side::right);
    std::vector<Piece> left = pieces_of(Side::left);
    std::reverse(left.begin(), left.end());
    for (Piece& piece : left) std::swap(piece.from_m, piece.to_m);
    close_to(from_of(left.front()), world_.wall_material, Side::left, world_.length_m);
    add_side(left, Side::left);
    close_to(plan_.walls.front().from, world_.wall_material, Side::left, 0.0);
    for (const WallSegment& wall : plan_.walls) plan_.outline.push_back(wall.from);
    return std::move(plan_);
  }

 private:
  void lay_centre_line() {
    Pose2 pose;
    double along = 0.0;
    leg_starts_m_.push_back(0.0);
    plan_.centre_line.push_back({0.0, 0.0});
    for (const Turn& turn : world_.turns) {
      const Point2 bend = transform(pose, Point2{turn.at_m - along, 0.0});
      plan_.centre_line.push_back(bend);
      leg_starts_m_.push_back(turn.at_m);
      pose = {bend.x_m, bend.y_m, pose.heading_rad + turn.angle_rad};
      along = turn.at_m;
    }
    plan_.centre_line.push_back(transform(pose, Point2{world_.length_m - along, 0.0}));
    legs_ = legs_of(plan_.centre_line);
  }

  [[nodiscard]] Point2 place(std::size_t leg, double along_m, double left_m) const {
    return transform(legs_[leg].start, Point2{along_m - leg_starts_m_[leg], left_m});
  }
  [[nodiscard]] Point2 from_of(const Piece& p) const { return place(p.leg, p.from_m, p.left_m); }
  [[nodiscard]] Point2 to_of(const Piece& p) const { return place(p.leg, p.to_m, p.left_m); }

  /// At a turn two walls meet in a mitre: the inner one is shorter, the outer one longer.
  [[nodiscard]] double mitre_m(std::size_t turn, double sign) const {
    return sign * world_.width_m / 2 * std::tan(world_.turns[turn].angle_rad / 2);
  }

  [[nodiscard]] std::vector<Piece> pieces_of(Side side) const {
    const double sign = side == Side::left ? 1.0 : -1.0;
    std::vector<Piece> pieces;
    for (std::size_t leg = 0; leg < legs_.size(); ++leg) {
      const bool last = leg + 1 == legs_.size();
      const double from = leg_starts_m_[leg] + (leg == 0 ? 0.0 : mitre_m(leg - 1, sign));
      const double to = last ? world_.length_m : leg_starts_m_[leg + 1] - mitre_m(leg, sign);
      const std::vector<double> cuts = cuts_between(from, to, side);
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const double middle = (cuts[i] + cuts[i + 1]) / 2;
        pieces.push_back({leg, cuts[i], cuts[i + 1], sign * half_width_m(world_, middle),
                          material_at(side, middle)});
      }
    }
    return pieces;
  }

  /// The ends of a stretch of wall with all borders of width and material between them.
  [[nodiscard]] std::vector<double> cuts_between(double from_m, double to_m, Side side) const {
    std::vector<double> cuts{from_m, to_m};
    const auto cut = [&](double at) {
      if (at > from_m && at < to_m) cuts.push_back(at);
    };
    for (const Widening& other : world_.widenings) {
      cut(other.from_m);
      cut(other.to_m);
    }
    for (const WallStretch& stretch : world_.walls) {
      if (stretch.side != side) continue;
      cut(stretch.from_m);
      cut(stretch.to_m);
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    return cuts;
  }

  [[nodiscard]] std::string material_at(Side side, double along_m) const {
    // A later entry paints over an earlier one.
    for (auto wall = world_.walls.rbegin(); wall != world_.walls.rend(); ++wall) {
      if (wall->side == side && along_m > wall->from_m && along_m < wall->to_m) {
        return wall->material;
      }
    }
    return world_.wall_material;
  }

  void add_side(const std::vector<Piece>& pieces, Side side) {
    for (const Piece& piece : pieces) {
      if (!plan_.walls.empty()) {  // a step of width: the wall that stands across
        close_to(from_of(piece), material_at(side, piece.from_m), side, piece.from_m);
      }
      add_wall(
          {from_of(piece), to_of(piece), 0.0, world_.height_m, piece.material, side, piece.from_m});
    }
  }

  /// Adds the wall from where the outline stands to `to`, if there is a way to go.
  void close_to(Point2 to, const std::string& material, Side side, double along_m) {
    const Point2 from = plan_.walls.back().to;
    if (distance_m(from, to) < 1e-9) return;
    add_wall({from, to, 0.0, world_.height_m, material, side, along_m});
  }

  void add_wall(WallSegment wall) {
    // One corner, one value: neighbours share it to the last bit.
    if (!plan_.walls.empty()) wall.from = plan_.walls.back().to;
    plan_.walls.push_back(std::move(wall));
  }

  const World& world_;
  FloorPlan plan_;
  std::vector<Leg> legs_;
  std::vector<double> leg_starts_m_;
};

}  // namespace

FloorPlan build_floor_plan(const World& world) {
  return PlanBuilder(world).build();
}

Pose2 FloorPlan::at(double along_m, double left_m) const {
  double done = 0.0;
  const std::vector<Leg> legs = legs_of(centre_line);
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (i + 1 == legs.size() || along_m <= done + legs[i].length_m) {
      return transform(legs[i].start, Pose2{along_m - done, left_m, 0.0});
    }
    done += legs[i].length_m;
  }
  return {along_m, left_m, 0.0};
}

Pose2 FloorPlan::along(const Pose2& plan) const {
  Pose2 best;
  double best_m = std::numeric_limits<double>::infinity();
  double done = 0.0;
  const std::vector<Leg> legs = legs_of(centre_line);
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Pose2 local = inverse_transform(legs[i].start, plan);
    // The first leg reaches back before the start wall, the last one on beyond the end.
    const double low = i == 0 ? -std::numeric_limits<double>::infinity() : 0.0;
    const double high =
        i + 1 == legs.size() ? std::numeric_limits<double>::infinity() : legs[i].length_m;
    const double x = std::clamp(local.x_m, low, high);
    const double away = std::hypot(local.x_m - x, local.y_m);
    // Outside a bend the nearest point is the bend itself: it counts as that place.
    if (away < best_m - 1e-12) {
      best_m = away;
      const double left = local.x_m == x ? local.y_m : std::copysign(away, local.y_m);
      best = {done + x, left, local.heading_rad};
    }
    done += legs[i].length_m;
  }
  return best;
}

}  // namespace striate::simulator
