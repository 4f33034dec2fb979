#pragma once

#include <optional>

#include "striate/base/geometry.hpp"
#include "striate/perception/obstacles/view_geometry.hpp"

namespace striate::perception {

/// Where the world's points, seen from the robot at one place, appeared from another.
class CarriedBack {
 public:
  /// A view and where the base was, in a frame common to both.
  struct From {
    ViewGeometry view;
    Pose2 base;
  };
  CarriedBack(const From& now, const From& before)
      : now_(now.view),
        before_(before.view),
        now_in_before_(inverse_transform(before.base, now.base)) {}

  /// `point` in the robot frame of now.
  [[nodiscard]] std::optional<ImagePoint> operator()(const SpacePoint& point) const {
    const Point2 floor = transform(now_in_before_, Point2{point.x_m, point.y_m});
    return before_.project({floor.x_m, floor.y_m, point.z_m});
  }
  /// A point in the robot frame of before, in that of now.
  [[nodiscard]] Point2 to_now(Point2 before) const {
    return inverse_transform(now_in_before_, before);
  }
  [[nodiscard]] const ViewGeometry& now() const { return now_; }
  [[nodiscard]] const ViewGeometry& before() const { return before_; }

 private:
  ViewGeometry now_;
  ViewGeometry before_;
  Pose2 now_in_before_;
};

}  // namespace striate::perception
