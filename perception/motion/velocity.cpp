#include "striate/perception/motion/velocity.hpp"

#include <algorithm>
#include <cmath>

#include "striate/base/index_within.hpp"

namespace striate::perception {
namespace {

constexpr std::size_t kFewestForVelocity =
    20;  ///< pixels of a thing; fewer fit any velocity (ours)
/// More are thinned out: each costs all velocities, 5 ms a thing in all (README)
constexpr std::size_t kMostPixels = 120;
/// Best difference over the median of all; above, no velocity stands out (ours)
constexpr double kClear = 0.8;
constexpr double kTrustedMover = 0.3;  ///< confidence; as MotionSettings::trusted
/// Share: a disparity may differ from the best velocity's by this; one px at 3.7 m
constexpr double kNearRange = 0.15;
/// m/s; 0.2 m in half a second, one px of disparity at 2.2 m
constexpr double kForwardStep_m_s = 0.4;
/// Each way; a thing half a metre before the shipped camera takes 800 (0.12 m / 50 px in half a
/// second), and more would take longer than a cycle
constexpr int kMostSteps = 2048;

/// Every so-many-th pixel.
std::vector<ThingPixel> thinned(const std::vector<ThingPixel>& pixels) {
  std::vector<ThingPixel> few;
  const std::size_t step = pixels.size() / kMostPixels + 1;
  for (std::size_t i = 0; i < pixels.size(); i += step) few.push_back(pixels[i]);
  return few;
}

/// Tries velocities of a few pixels.
class Search {
 public:
  Search(const std::vector<ThingPixel>& pixels, const CarriedBack& carried,
         const EarlierView& before, const cv::Mat1b& grey)
      : pixels_(pixels), carried_(carried), before_(before), grey_(grey) {}

  /// Where the pixel was if it moved so; nothing outside the image.
  [[nodiscard]] std::optional<ImagePoint> was(const ThingPixel& pixel, Point2 velocity) const {
    const auto place = carried_({pixel.at.x_m - velocity.x_m * before_.seconds,
                                 pixel.at.y_m - velocity.y_m * before_.seconds, pixel.at.z_m});
    const bool inside = place && place->u_px >= 0.0 && place->v_px >= 0.0 &&
                        place->u_px <= grey_.cols - 1.0 && place->v_px <= grey_.rows - 1.0;
    return inside ? place : std::nullopt;
  }
  [[nodiscard]] static cv::Point pixel_of(const ImagePoint& place) {
    return {nearest_cell(place.u_px), nearest_cell(place.v_px)};
  }

  /// Mean |difference| of greys, less the mean difference (exposure may have changed); nothing
  /// where less than half of the thing was in the image.
  [[nodiscard]] std::optional<double> difference(Point2 velocity) {
    differences_.clear();
    double sum = 0.0;
    for (const ThingPixel& pixel : pixels_) {
      const auto place = was(pixel, velocity);
      if (!place) continue;
      differences_.push_back(grey_(pixel.v, pixel.u) - before_.grey(pixel_of(*place)));
      sum += differences_.back();
    }
    if (2 * differences_.size() < pixels_.size()) return std::nullopt;
    const double offset = sum / static_cast<double>(differences_.size());
    double total = 0.0;
    for (const double d : differences_) total += std::abs(d - offset);
    return total / static_cast<double>(differences_.size());
  }

 private:
  const std::vector<ThingPixel>& pixels_;
  const CarriedBack& carried_;
  const EarlierView& before_;
  const cv::Mat1b& grey_;
  std::vector<double> differences_;
};

double median(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The velocity that explains the pixels best; nothing where it does not stand out. Steps sideways
/// are one pixel of the earlier image.
std::optional<Point2> best_velocity(Search& search, double sideways_step_m_s, double fastest_m_s) {
  const int forward_steps = cut_within(fastest_m_s / kForwardStep_m_s, 0, kMostSteps);
  const int sideways_steps = cut_within(fastest_m_s / sideways_step_m_s, 0, kMostSteps);
  std::vector<double> all;
  std::optional<Point2> best;
  double least = 0.0;
  for (int i = -forward_steps; i <= forward_steps; ++i) {
    for (int k = -sideways_steps; k <= sideways_steps; ++k) {
      const Point2 velocity{i * kForwardStep_m_s, k * sideways_step_m_s};
      const std::optional<double> difference = search.difference(velocity);
      if (!difference) continue;
      if (!best || *difference < least) {
        best = velocity;
        least = *difference;
      }
      all.push_back(*difference);
    }
  }
  if (all.size() < 5) return std::nullopt;
  return least < kClear * median(all) ? best : std::nullopt;
}

}  // namespace

std::optional<Point2> find_velocity(const std::vector<ThingPixel>& pixels, const cv::Mat1b& grey,
                                    const CarriedBack& carried, const EarlierView& before,
                                    double fastest_m_s) {
  if (pixels.size() < kFewestForVelocity || before.seconds <= 0.0) return std::nullopt;
  const std::vector<ThingPixel> few = thinned(pixels);
  Search search(few, carried, before, grey);
  const auto middle = carried.now().project(few[few.size() / 2].at);
  if (!middle) return std::nullopt;
  const double step_m_s = before.disparity.baseline_m / middle->d_px / before.seconds;
  const std::optional<Point2> best = best_velocity(search, step_m_s, fastest_m_s);
  if (!best) return std::nullopt;
  std::vector<double> x, y;  // velocities of the pixels whose disparity was known there
  for (const ThingPixel& pixel : few) {
    const auto place = search.was(pixel, *best);
    if (!place) continue;
    const cv::Point at = Search::pixel_of(*place);
    const float d = before.disparity.disparity_px(at);
    if (!std::isfinite(d) || before.disparity.confidence(at) < kTrustedMover ||
        std::abs(d - place->d_px) > kNearRange * place->d_px) {
      continue;
    }
    const SpacePoint there = carried.before().point(at.x, at.y, d);
    const Point2 then = carried.to_now({there.x_m, there.y_m});
    x.push_back((pixel.at.x_m - then.x_m) / before.seconds);
    y.push_back((pixel.at.y_m - then.y_m) / before.seconds);
  }
  if (x.size() < kFewestForVelocity / 2) return std::nullopt;
  return Point2{median(x), median(y)};
}

}  // namespace striate::perception
