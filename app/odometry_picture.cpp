#include "striate/app/odometry_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "striate/agent/pictures/canvas.hpp"

namespace striate::app {
namespace {

using agent::pictures::drawn_px;
using evaluation::PosePair;

constexpr int kPlan_px = 640;    // px a side: as the plan of a run (agent/pictures)
constexpr int kErrors_px = 160;  // px high, below the plan (ours)
constexpr int kMargin_px = 40;   // px: room for a line of text (ours)

/// The two axes along which the way goes farthest, in their order; the third one points to us.
std::array<int, 2> widest_axes(const std::vector<PosePair>& pairs) {
  std::array<double, 3> spread{};
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::ranges::minmax_element(
        pairs, {}, [axis](const PosePair& pair) { return pair.truth.position_m[axis]; });
    spread[static_cast<std::size_t>(axis)] =
        high->truth.position_m[axis] - low->truth.position_m[axis];
  }
  const auto least = std::ranges::min_element(spread) - spread.begin();
  if (least == 0) return {1, 2};
  return least == 1 ? std::array<int, 2>{0, 2} : std::array<int, 2>{0, 1};
}

class PlanScale {
 public:
  PlanScale(const std::vector<cv::Vec3d>& points, std::array<int, 2> axes) : axes_(axes) {
    cv::Vec2d low(HUGE_VAL, HUGE_VAL);
    cv::Vec2d high(-HUGE_VAL, -HUGE_VAL);
    for (const cv::Vec3d& point : points) {
      for (int k = 0; k < 2; ++k) {
        low[k] = std::min(low[k], point[axes_[static_cast<std::size_t>(k)]]);
        high[k] = std::max(high[k], point[axes_[static_cast<std::size_t>(k)]]);
      }
    }
    middle_ = 0.5 * (low + high);
    const double side_m = std::max({high[0] - low[0], high[1] - low[1], 1e-6});
    px_per_m_ = (kPlan_px - 2 * kMargin_px) / side_m;
  }
  [[nodiscard]] cv::Point at(const cv::Vec3d& point) const {
    const double x = point[axes_[0]] - middle_[0];
    const double y = point[axes_[1]] - middle_[1];
    return {drawn_px(0.5 * kPlan_px + px_per_m_ * x), drawn_px(0.5 * kPlan_px - px_per_m_ * y)};
  }
  [[nodiscard]] double px_per_m() const { return px_per_m_; }

 private:
  std::array<int, 2> axes_;
  cv::Vec2d middle_;
  double px_per_m_ = 1.0;
};

void draw_way(cv::Mat3b& image, const PlanScale& scale, const std::vector<cv::Vec3d>& points,
              const cv::Scalar& colour) {
  for (std::size_t k = 1; k < points.size(); ++k) {
    cv::line(image, scale.at(points[k - 1]), scale.at(points[k]), colour, 2, cv::LINE_AA);
  }
  if (!points.empty()) cv::circle(image, scale.at(points.front()), 4, colour, -1, cv::LINE_AA);
}

void draw_ruler(cv::Mat3b& image, const PlanScale& scale) {
  const double wide_m = 0.25 * kPlan_px / scale.px_per_m();
  const double power = std::pow(10.0, std::floor(std::log10(wide_m)));
  const double ratio = wide_m / power;
  const double length_m = power * (ratio >= 5.0 ? 5.0 : ratio >= 2.0 ? 2.0 : 1.0);
  const cv::Point from(kMargin_px, kPlan_px - 14);
  cv::line(image, from, {drawn_px(from.x + length_m * scale.px_per_m()), from.y},
           agent::pictures::kQuietInk, 2);
  agent::pictures::write(image, fmt::format("{:g} m", length_m), {from.x, from.y - 6},
                         agent::pictures::kQuietInk);
}

void draw_errors(cv::Mat3b& image, const evaluation::OdometryScores& scores) {
  const double most = std::max(scores.absolute.most, 1e-9);
  const double count = std::max<double>(1.0, static_cast<double>(scores.absolute_m.size()) - 1.0);
  const int floor = image.rows - 14;
  std::vector<cv::Point> line;
  for (std::size_t k = 0; k < scores.absolute_m.size(); ++k) {
    line.emplace_back(
        drawn_px(kMargin_px + (kPlan_px - 2.0 * kMargin_px) * static_cast<double>(k) / count),
        drawn_px(floor - (kErrors_px - kMargin_px) * scores.absolute_m[k] / most));
  }
  cv::polylines(image, line, false, agent::pictures::kBlocked, 1, cv::LINE_AA);
  agent::pictures::write(image, fmt::format("error of the position, at most {:.3f} m", most),
                         {kMargin_px, kPlan_px + 16}, agent::pictures::kQuietInk);
}

}  // namespace

cv::Mat3b draw_odometry(const evaluation::OdometryScores& scores) {
  std::vector<cv::Vec3d> truth;
  std::vector<cv::Vec3d> estimate;
  for (const PosePair& pair : scores.poses.pairs) {
    truth.push_back(pair.truth.position_m);
    estimate.push_back(evaluation::aligned(pair.estimate, scores.alignment).position_m);
  }
  std::vector<cv::Vec3d> all = truth;
  all.insert(all.end(), estimate.begin(), estimate.end());
  const std::array<int, 2> axes = widest_axes(scores.poses.pairs);
  const PlanScale scale(all, axes);
  cv::Mat3b image(kPlan_px + kErrors_px, kPlan_px);
  image.setTo(agent::pictures::kBackground);
  draw_way(image, scale, truth, agent::pictures::kQuietInk);
  draw_way(image, scale, estimate, agent::pictures::kCorridor);
  draw_ruler(image, scale);
  constexpr const char* kAxes = "xyz";
  agent::pictures::write(image, "truth", {kMargin_px, 20}, agent::pictures::kQuietInk);
  agent::pictures::write(image, "estimate, aligned", {kMargin_px + 60, 20},
                         agent::pictures::kCorridor);
  agent::pictures::write(image,
                         fmt::format("{} to the right, {} up; ATE {:.3f} m", kAxes[axes[0]],
                                     kAxes[axes[1]], scores.absolute.rmse),
                         {kMargin_px, 38}, agent::pictures::kQuietInk);
  draw_errors(image, scores);
  return image;
}

}  // namespace striate::app
