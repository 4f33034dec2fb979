#include "striate/agent/pictures/plan_strip.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "striate/base/index_within.hpp"

namespace striate::agent::pictures {
namespace {

constexpr int kClear_px = 2;  // px around words and lines (ours)

}  // namespace

Bounds bounds_of(const simulator::FloorPlan& plan, double from_x_m, double to_x_m) {
  Bounds box{1e9, 1e9, -1e9, -1e9};
  for (std::size_t i = 0; i < plan.outline.size(); ++i) {
    const Point2 a = plan.outline[i];
    const Point2 b = plan.outline[(i + 1) % plan.outline.size()];
    if (std::max(a.x_m, b.x_m) < from_x_m || std::min(a.x_m, b.x_m) > to_x_m) continue;
    box.low_x_m = std::min({box.low_x_m, a.x_m, b.x_m});
    box.low_y_m = std::min({box.low_y_m, a.y_m, b.y_m});
    box.high_x_m = std::max({box.high_x_m, a.x_m, b.x_m});
    box.high_y_m = std::max({box.high_y_m, a.y_m, b.y_m});
  }
  return box;
}

void Strip::floor(const simulator::FloorPlan& plan, const simulator::ImageSource* light) {
  std::vector<cv::Point> outline;
  for (const Point2& corner : plan.outline) outline.push_back(pixel(corner));
  cv::Mat1b inside(image_.size(), static_cast<uchar>(0));
  cv::fillPoly(inside, std::vector<std::vector<cv::Point>>{outline}, 255);
  constexpr int kBlock = 6;  // px of the chequered floor outside
  for (int v = 0; v < image_.rows; v += kBlock) {
    for (int u = 0; u < image_.cols; u += kBlock) {
      const cv::Rect block = cv::Rect(u, v, kBlock, kBlock) & cv::Rect({}, image_.size());
      if (cv::countNonZero(inside(block)) == 0) continue;
      const double level =
          light == nullptr ? 1.0 : std::clamp(light->light_level(at(u, v)), 0., 1.);
      const double grey = 150.0 + 90.0 * std::sqrt(level);
      image_(block).setTo(cv::Scalar(grey, grey, grey), inside(block));
    }
  }
  for (const simulator::WallSegment& wall : plan.walls) line(wall.from, wall.to, kPlanInk, 3);
}

void Strip::shape(const simulator::ConvexShape& shape, const cv::Scalar& colour) {
  if (shape.corners.size() < 3) {
    cv::circle(image_, pixel(shape.corners.front()), px(shape.radius_m), colour, cv::FILLED,
               cv::LINE_AA);
    cv::circle(image_, pixel(shape.corners.front()), px(shape.radius_m), kPlanInk, 1, cv::LINE_AA);
    cv::circle(labels_.taken(), pixel(shape.corners.front()), px(shape.radius_m), 255, cv::FILLED);
    return;
  }
  std::vector<cv::Point> corners;
  for (const Point2& corner : shape.corners) corners.push_back(pixel(corner));
  cv::fillConvexPoly(image_, corners, colour, cv::LINE_AA);
  cv::polylines(image_, corners, true, kPlanInk, 1, cv::LINE_AA);
  cv::fillConvexPoly(labels_.taken(), corners, 255);
}

void Strip::line(Point2 from, Point2 to, const cv::Scalar& colour, int thickness) {
  cv::line(image_, pixel(from), pixel(to), colour, thickness, cv::LINE_AA);
  cv::line(labels_.taken(), pixel(from), pixel(to), 255, thickness + 2 * kClear_px);
}

void Strip::dot(Point2 place, int radius_px, const cv::Scalar& colour, int thickness) {
  cv::circle(image_, pixel(place), radius_px, colour, thickness, cv::LINE_AA);
  cv::circle(labels_.taken(), pixel(place), radius_px + kClear_px, 255, cv::FILLED);
}

void Strip::cross(Point2 place) {
  const cv::Point c = pixel(place);
  for (const int sign : {-1, 1}) {
    for (const cv::Mat& drawn : {cv::Mat(image_), cv::Mat(labels_.taken())}) {
      cv::line(drawn, {c.x - 12, c.y - 12 * sign}, {c.x + 12, c.y + 12 * sign}, kHit, 4,
               cv::LINE_AA);
    }
  }
}

void Strip::text(Point2 place, const std::string& words, const cv::Scalar& colour, double size) {
  if (const cv::Point at = pixel(place); at.x < 0 || at.x >= image_.cols) return;
  words_.push_back({place, words, colour, size});
}

void Strip::draw_words() {
  for (const Words& one : words_) {
    int below = 0;
    const cv::Size size = cv::getTextSize(one.text, cv::FONT_HERSHEY_SIMPLEX, one.size, 1, &below);
    const cv::Rect place =
        labels_.take(pixel(one.place), size + cv::Size(2 * kClear_px, below + 2 * kClear_px));
    const cv::Point from(place.x + kClear_px, place.y + kClear_px + size.height);
    cv::putText(image_, one.text, from, cv::FONT_HERSHEY_SIMPLEX, one.size,
                cv::Scalar(255, 255, 255), 3, cv::LINE_AA);
    cv::putText(image_, one.text, from, cv::FONT_HERSHEY_SIMPLEX, one.size, one.colour, 1,
                cv::LINE_AA);
  }
}

int Strip::px(double length_m) {
  return std::max(2, nearest_cell(length_m * kScale));
}

cv::Point Strip::pixel(Point2 plan) const {
  return {nearest_cell((plan.x_m - low_x_m_) * kScale),
          nearest_cell((high_y_m_ - plan.y_m) * kScale)};
}

Point2 Strip::at(int u, int v) const {
  return {low_x_m_ + u / kScale, high_y_m_ - v / kScale};
}

}  // namespace striate::agent::pictures
