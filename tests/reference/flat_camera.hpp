#pragma once

#include "striate/perception/percept.hpp"
#include "tests/reference/flat_world.hpp"

/// What the robot's vision would say in the flat world, with the real one's limits and errors.
namespace striate::flat {

struct CameraErrors {
  double disparity_px = 0.30;      ///< shared by neighbouring columns
  double own_disparity_px = 0.12;  ///< of each column
  double unknown_share = 0.06;     ///< of columns, at random
  double unknown_bursts = 0.15;    ///< per image: a run of columns knows nothing
  double lone_phantoms = 0.004;    ///< per column: something where nothing is
  double phantom_bursts = 0.015;   ///< per image: three to five such columns in a row
  double floor_seen = 0.85;        ///< share of columns in which floor is seen
};

class Camera {
 public:
  static constexpr int kColumns = 160;
  static constexpr double kBaseline_m = 0.12;
  static constexpr double kFloorFar_m = 4.6;

  /// Of a Pioneer by default: 203 px, 33 degrees upright, Z = 24.4 m / d.
  explicit Camera(std::uint64_t seed, const CameraErrors& errors = {},
                  const RobotDescription& robot = {})
      : random_(seed ^ 0x5555ULL), errors_(errors), height_m_(robot.camera_height_m) {
    const double wider =
        std::tan(0.5 * robot.view_rad) / std::tan(0.5 * RobotDescription{}.view_rad);
    focal_px_ = 203.0 / wider;
    disparity_metre_ = 24.4 / wider;
    half_rows_rad_ = wider == 1.0 ? 0.2871 : std::atan(wider * std::tan(0.2871));
  }

  perception::Percept look(const World& world, TimePoint stamp) {
    perception::Percept percept;
    percept.stamp = stamp;
    percept.valid = true;
    percept.light_level = 0.45;
    percept.noise_level = 1.0;
    percept.disparity.focal_px = focal_px_;
    percept.disparity.baseline_m = kBaseline_m;
    percept.columns.resize(kColumns);
    see_all(world, percept);
    group(percept);
    fatten(percept);
    disturb(percept);
    if (world.layout().corridor_views && random_.chance(0.5)) see_corridor(world, percept);
    return percept;
  }

 private:
  struct Hit {
    double distance_m;
    double bottom_m;
    double top_m;
    bool blank;
  };

  void see_all(const World& world, perception::Percept& percept) {
    double node[kColumns / 8 + 2];
    heights_m_.assign(kColumns, 0.0);
    for (double& n : node) n = errors_.disparity_px * random_.normal();
    for (int u = 0; u < kColumns; ++u) {
      const double bearing = world.head().pan_rad + std::atan((79.5 - u) / focal_px_);
      perception::Column& column = percept.columns[static_cast<std::size_t>(u)];
      column.bearing_rad = bearing;
      const double t = (u % 8) / 8.0;
      const double error_px = (1.0 - t) * node[u / 8] + t * node[u / 8 + 1] +
                              errors_.own_disparity_px * random_.normal();
      heights_m_[static_cast<std::size_t>(u)] = see(world, bearing, error_px, column);
    }
  }

  /// Returns the height of the highest part seen of what the column meets.
  double see(const World& world, double bearing, double error_px, perception::Column& column) {
    double height_m = 0.0;
    hits_.clear();
    cast(world, bearing);
    std::sort(hits_.begin(), hits_.end(),
              [](const Hit& a, const Hit& b) { return a.distance_m < b.distance_m; });
    const double low = world.head().tilt_rad - half_rows_rad_;
    const double high = world.head().tilt_rad + half_rows_rad_;
    double floor_from_m = low < -0.01 ? height_m_ / std::tan(-low) : 99.0;
    double floor_to_m = std::min(kFloorFar_m, high < -0.01 ? height_m_ / std::tan(-high) : 99.0);
    for (const Hit& hit : hits_) {
      const double seen_low = std::max(hit.bottom_m, height_m_ + hit.distance_m * std::tan(low));
      const double seen_high = std::min(hit.top_m, height_m_ + hit.distance_m * std::tan(high));
      const bool visible = (seen_high - seen_low) * focal_px_ / hit.distance_m > 4.0;
      if (visible) {
        floor_to_m = std::min(floor_to_m, hit.distance_m - 0.05);
        const double disparity = disparity_metre_ / hit.distance_m + error_px;
        if (!hit.blank && disparity > 2.5) {
          column.obstacle_m = disparity_metre_ / disparity;
          column.obstacle_confidence = 0.9;
          height_m = seen_high;
          floor_to_m = std::min(floor_to_m, column.obstacle_m - 0.1);
        }
        break;
      }
      // Out of view, but it hides floor behind it.
      if (hit.top_m < height_m_) {
        floor_from_m =
            std::max(floor_from_m, hit.distance_m * height_m_ / (height_m_ - hit.top_m) + 0.05);
      } else {
        floor_to_m = std::min(floor_to_m, hit.distance_m);
      }
    }
    if (random_.chance(errors_.floor_seen) && floor_to_m > floor_from_m) {
      column.free_from_m = floor_from_m;
      column.free_to_m = floor_to_m;
      column.free_confidence = 0.8;
    }
    return height_m;
  }

  void cast(const World& world, double bearing) {
    const double angle = world.pose().heading_rad + bearing;
    const Point2 eye{world.pose().x_m, world.pose().y_m};
    const double dx = std::cos(angle);
    const double dy = std::sin(angle);
    for (const Face& face : world.layout().faces) {
      const double ex = face.to.x_m - face.from.x_m;
      const double ey = face.to.y_m - face.from.y_m;
      const double cross = dx * ey - dy * ex;
      if (std::abs(cross) < 1e-12) continue;
      const double fx = face.from.x_m - eye.x_m;
      const double fy = face.from.y_m - eye.y_m;
      const double t = (fx * ey - fy * ex) / cross;
      const double s = (fx * dy - fy * dx) / cross;
      if (t > 0.05 && t < 9.0 && s >= 0.0 && s <= 1.0) {
        hits_.push_back({t, face.bottom_m, face.top_m, face.blank});
      }
    }
    const auto round = [&](Point2 at, double radius_m, double top_m) {
      const double fx = at.x_m - eye.x_m;
      const double fy = at.y_m - eye.y_m;
      const double along = fx * dx + fy * dy;
      const double aside = fx * dy - fy * dx;
      if (along <= 0.0 || along > 9.0 || std::abs(aside) >= radius_m) return;
      const double t = along - std::sqrt(radius_m * radius_m - aside * aside);
      if (t > 0.05) hits_.push_back({t, 0.0, top_m, false});
    };
    for (const Column2& column : world.layout().columns) {
      round(column.at, column.radius_m, column.top_m);
    }
    for (const Person& person : world.layout().people) {
      if (person.present()) round(person.at, kPersonRadius_m, kPersonTop_m);
    }
  }

  // Neighbouring columns at about the same distance are one blob.
  void group(perception::Percept& percept) const {
    for (int u = 0; u < kColumns; ++u) {
      const perception::Column& column = percept.columns[static_cast<std::size_t>(u)];
      if (!std::isfinite(column.obstacle_m)) continue;
      const double height_m = heights_m_[static_cast<std::size_t>(u)];
      if (!percept.obstacles.empty() && percept.obstacles.back().to_u_px == u - 1 &&
          std::abs(percept.obstacles.back().distance_m - column.obstacle_m) < 0.25) {
        perception::Obstacle& blob = percept.obstacles.back();
        blob.to_u_px = u;
        blob.distance_m = std::min(blob.distance_m, column.obstacle_m);
        blob.height_m = std::max(blob.height_m, height_m);
      } else {
        percept.obstacles.push_back(
            {column.bearing_rad, column.obstacle_m, 0.0, height_m, 0.9, u, u});
      }
    }
  }

  // Stereo with support windows widens what stands before something farther.
  static void fatten(perception::Percept& percept) {
    const std::vector<perception::Column> seen = percept.columns;
    for (int u = 0; u < kColumns; ++u) {
      perception::Column& column = percept.columns[static_cast<std::size_t>(u)];
      for (int k = std::max(0, u - 2); k <= std::min(kColumns - 1, u + 2); ++k) {
        const perception::Column& other = seen[static_cast<std::size_t>(k)];
        if (other.obstacle_m < column.obstacle_m - 0.1) {
          column.obstacle_m = other.obstacle_m;
          column.obstacle_confidence = other.obstacle_confidence;
          column.free_to_m = std::min(column.free_to_m, column.obstacle_m - 0.1);
        }
      }
    }
  }

  void disturb(perception::Percept& percept) {
    for (perception::Column& column : percept.columns) {
      if (random_.chance(errors_.unknown_share)) blind(column);
      if (random_.chance(errors_.lone_phantoms)) phantom(column, random_.between(0.8, 4.0));
    }
    if (random_.chance(errors_.unknown_bursts)) {
      const auto from = static_cast<std::size_t>(random_.between(0.0, 120.0));
      for (std::size_t u = from; u < from + 40; ++u) blind(percept.columns[u]);
    }
    if (random_.chance(errors_.phantom_bursts)) {
      const auto from = static_cast<std::size_t>(random_.between(0.0, 154.0));
      const double distance_m = random_.between(1.0, 4.0);
      for (std::size_t u = from; u < from + 4; ++u) phantom(percept.columns[u], distance_m);
    }
  }

  static void blind(perception::Column& column) {
    const double bearing = column.bearing_rad;
    column = {};
    column.bearing_rad = bearing;
  }

  static void phantom(perception::Column& column, double distance_m) {
    column.obstacle_m = distance_m;
    column.obstacle_confidence = 0.6;
    column.free_to_m = std::min(column.free_to_m, distance_m - 0.1);
  }

  void see_corridor(const World& world, perception::Percept& percept) {
    // Only looking about along it, and only as good as lines in 160 columns are.
    const double heading = -world.pose().heading_rad;
    if (std::abs(wrap_angle(heading - world.head().pan_rad)) > 0.5) return;
    percept.corridor.valid = true;
    percept.corridor.confidence = 0.6;
    percept.corridor.heading_rad = heading + 0.03 * random_.normal();
    if (random_.chance(0.08)) percept.corridor.heading_rad += 0.3 * random_.normal();
  }

  Random random_;
  CameraErrors errors_;
  double height_m_;
  double focal_px_ = 0.0;
  double disparity_metre_ = 0.0;  ///< Z = this / disparity
  double half_rows_rad_ = 0.0;
  std::vector<Hit> hits_;
  std::vector<double> heights_m_;
};

}  // namespace striate::flat
