#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "striate/agent/pictures/label_places.hpp"
#include "striate/platform/simulator/image_source.hpp"
#include "striate/platform/simulator/scene.hpp"
#include "striate/platform/simulator/static_shapes.hpp"

/// A strip of a plan: the frame in which it is drawn.
namespace striate::agent::pictures {

constexpr double kScale = 62.0;  // px per metre: a chair is 30 px wide (ours)

inline const cv::Scalar kPlanInk(60, 50, 45);

inline const cv::Scalar kHit(0, 0, 220);

struct Bounds {
  double low_x_m, low_y_m, high_x_m, high_y_m;
};

/// Of the outline between two x; a strip is no higher than the corridor is wide there.
[[nodiscard]] Bounds bounds_of(const simulator::FloorPlan& plan, double from_x_m, double to_x_m);

/// One stretch of the plan with its own place in the image.
class Strip {
 public:
  Strip(cv::Mat3b image, double low_x_m, double high_y_m)
      : image_(std::move(image)), labels_(image_.size()), low_x_m_(low_x_m), high_y_m_(high_y_m) {}

  void floor(const simulator::FloorPlan& plan, const simulator::ImageSource* light);
  void shape(const simulator::ConvexShape& shape, const cv::Scalar& colour);
  void line(Point2 from, Point2 to, const cv::Scalar& colour, int thickness);
  void dot(Point2 place, int radius_px, const cv::Scalar& colour, int thickness);
  void cross(Point2 place);
  /// Words beside a place. They are drawn last, where they lie on nothing else.
  void text(Point2 place, const std::string& words, const cv::Scalar& colour, double size = 0.42);
  void draw_words();

 private:
  [[nodiscard]] static int px(double length_m);
  [[nodiscard]] cv::Point pixel(Point2 plan) const;
  [[nodiscard]] Point2 at(int u, int v) const;

  struct Words {
    Point2 place;
    std::string text;
    cv::Scalar colour;
    double size;
  };

  cv::Mat3b image_;
  LabelPlaces labels_;
  std::vector<Words> words_;
  double low_x_m_;
  double high_y_m_;
};

}  // namespace striate::agent::pictures
