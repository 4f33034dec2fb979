#include "striate/agent/pictures/map_picture.hpp"

#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "striate/agent/pictures/canvas.hpp"

namespace striate::agent::pictures {
namespace {

constexpr double kReach_m = 5.0;  // m to each side: where the next seconds of driving are (ours)
const cv::Vec3b kUnknown(78, 74, 70);
const cv::Vec3b kFreeCell(176, 214, 178);
const cv::Vec3b kOccupiedCell(40, 36, 160);
const cv::Scalar kWall(220, 140, 40);
const cv::Scalar kTrajectory(200, 90, 20);
const cv::Scalar kRobot(30, 30, 30);
const cv::Scalar kRing(110, 106, 100);

class MapPicture {
 public:
  MapPicture(const memory::ShortTermMemory& memory, int side_px)
      : memory_(memory), scale_(side_px / (2.0 * kReach_m)), image_(side_px, side_px, kUnknown) {}

  void draw_cells() {
    for (int v = 0; v < image_.rows; ++v) {
      for (int u = 0; u < image_.cols; ++u) {
        const memory::GridCell cell =
            memory::LocalGrid::cell_of(transform(memory_.pose(), at(u, v)));
        const memory::CellState state = memory_.map().state(cell);
        if (state == memory::CellState::free) image_(v, u) = kFreeCell;
        if (state == memory::CellState::occupied) image_(v, u) = kOccupiedCell;
      }
    }
  }

  void draw_rings() {
    for (int metre = 1; metre < static_cast<int>(kReach_m) + 1; ++metre) {
      cv::circle(image_, pixel({0, 0}), static_cast<int>(metre * scale_), kRing, 1, cv::LINE_AA);
    }
  }

  void draw_corridor() {
    const memory::CorridorMemory& corridor = memory_.corridor();
    const double axis_rad = wrap_angle(corridor.axis_rad() - memory_.pose().heading_rad);
    const Pose2 along{0.0, 0.0, axis_rad};
    for (const double left_m : {corridor.left_m(), -corridor.right_m()}) {
      if (!std::isfinite(left_m)) continue;
      line(transform(along, Point2{-8, left_m}), transform(along, Point2{8, left_m}), kWall, 2);
    }
  }

  void draw_view(const RobotDescription& robot) {
    const double pan_rad = memory_.head().pan_rad;
    for (const double side : {-1.0, 1.0}) {
      const double bearing_rad = pan_rad + side * 0.5 * robot.view_rad;
      line({0, 0}, {6 * std::cos(bearing_rad), 6 * std::sin(bearing_rad)},
           cv::Scalar(240, 240, 240), 1);
    }
  }

  void draw_trajectory(const std::deque<Point2>& trajectory) {
    for (std::size_t i = 1; i < trajectory.size(); ++i) {
      line(inverse_transform(memory_.pose(), trajectory[i - 1]),
           inverse_transform(memory_.pose(), trajectory[i]), kTrajectory, 2);
    }
  }

  void draw_robot(const RobotDescription& robot) {
    const std::array<cv::Point, 4> outline = {
        pixel({robot.front_m, robot.half_width_m}), pixel({robot.front_m, -robot.half_width_m}),
        pixel({-robot.rear_m, -robot.half_width_m}), pixel({-robot.rear_m, robot.half_width_m})};
    cv::fillConvexPoly(image_, outline.data(), 4, kRobot, cv::LINE_AA);
    line({0, 0}, {robot.front_m, 0}, cv::Scalar(255, 255, 255), 2);
  }

  cv::Mat3b take() { return image_; }

 private:
  /// Robot frame; up in the image is forward.
  [[nodiscard]] Point2 at(int u, int v) const {
    return {(image_.rows / 2.0 - v) / scale_, (image_.cols / 2.0 - u) / scale_};
  }
  [[nodiscard]] cv::Point pixel(Point2 robot) const {
    return {drawn_px(image_.cols / 2.0 - robot.y_m * scale_),
            drawn_px(image_.rows / 2.0 - robot.x_m * scale_)};
  }
  void line(Point2 from, Point2 to, const cv::Scalar& colour, int thickness) {
    cv::line(image_, pixel(from), pixel(to), colour, thickness, cv::LINE_AA);
  }

  const memory::ShortTermMemory& memory_;
  double scale_;
  cv::Mat3b image_;
};

}  // namespace

cv::Mat3b draw_map(const memory::ShortTermMemory& memory, const RobotDescription& robot,
                   const std::deque<Point2>& trajectory, int side_px) {
  MapPicture image(memory, side_px);
  image.draw_cells();
  image.draw_rings();
  image.draw_corridor();
  image.draw_view(robot);
  image.draw_trajectory(trajectory);
  image.draw_robot(robot);
  return image.take();
}

}  // namespace striate::agent::pictures
