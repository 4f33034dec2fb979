#include "striate/agent/pictures/disparity_colours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "striate/agent/pictures/canvas.hpp"

namespace striate::agent::pictures {
namespace {

/// m: what is nearer is as red; a stop from 0.75 m/s and the robot's front
constexpr double kReddest_m = 0.7;
constexpr double kGamma = 0.6;  // far distances get more than their share of the colours
constexpr int kHatch = 8;       // px between the lines of what is unknown

cv::Mat3b colour_table(int map) {
  cv::Mat1b ramp(1, 256);
  for (int i = 0; i < 256; ++i) ramp(0, i) = static_cast<uchar>(i);
  cv::Mat3b table;
  cv::applyColorMap(ramp, table, map);
  return table;
}

double place_of(double disparity_px, const DisparityScale& scale) {
  return std::pow(std::clamp(disparity_px / scale.most_px, 0.0, 1.0), kGamma);
}

/// The table's ends are nearly black; they are left out.
cv::Vec3b turbo(const cv::Mat3b& table, double place) {
  return table(0, static_cast<int>(14.0 + 226.0 * std::clamp(place, 0.0, 1.0)));
}

cv::Vec3b hatch(int v, int u) {
  return (u + v) % kHatch < 2 ? cv::Vec3b(58, 56, 54) : cv::Vec3b(40, 38, 36);
}

}  // namespace

DisparityScale scale_for(const perception::DisparityMap& map, bool metric) {
  DisparityScale scale;
  scale.focal_baseline = metric ? map.focal_px * map.baseline_m : 0.0;
  if (scale.focal_baseline > 0.0) {
    scale.most_px = scale.focal_baseline / kReddest_m;
    return scale;
  }
  std::vector<float> known;
  for (const float d : map.disparity_px) {
    if (std::isfinite(d)) known.push_back(d);
  }
  scale.most_px = 8.0;
  if (known.empty()) return scale;
  const auto high = known.begin() + static_cast<std::ptrdiff_t>(known.size() * 98 / 100);
  std::nth_element(known.begin(), high, known.end());
  scale.most_px = std::max(8.0, std::ceil(static_cast<double>(*high)));
  return scale;
}

cv::Mat3b colour_disparity(const perception::DisparityMap& map, const DisparityScale& scale,
                           cv::Size size) {
  static const cv::Mat3b table = colour_table(cv::COLORMAP_TURBO);
  cv::Mat3b out(size);
  const cv::Size from = map.disparity_px.size();
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      float d = perception::kNoMatch;
      if (!from.empty()) {
        d = map.disparity_px(v * from.height / size.height, u * from.width / size.width);
      }
      out(v, u) = std::isfinite(d) ? turbo(table, place_of(d, scale)) : hatch(v, u);
    }
  }
  return out;
}

void draw_legend(cv::Mat3b& image, cv::Rect where, const DisparityScale& scale) {
  const cv::Mat3b table = colour_table(cv::COLORMAP_TURBO);
  for (int x = 0; x < where.width; ++x) {
    const cv::Vec3b c = turbo(table, static_cast<double>(x) / (where.width - 1));
    cv::line(image, {where.x + x, where.y}, {where.x + x, where.y + where.height - 1},
             cv::Scalar(c[0], c[1], c[2]));
  }
  const auto mark = [&](double disparity_px, const std::string& text) {
    const int x = where.x + static_cast<int>(place_of(disparity_px, scale) * (where.width - 1));
    const int y = where.y + where.height;
    cv::line(image, {x, y}, {x, y + 3}, kQuietInk);
    const int width = text_width(text, 0.8);
    const int left = std::clamp(x - width / 2, where.x, where.x + where.width - width);
    write(image, text, {left, y + 15}, kQuietInk, 0.8);
  };
  if (scale.focal_baseline > 0.0) {
    for (const double m : {8.0, 4.0, 2.0, 1.0}) {
      mark(scale.focal_baseline / m, fmt::format("{:g} m", m));
    }
  } else {
    for (const double share : {0.1, 0.3, 0.6, 1.0}) {
      mark(share * scale.most_px, fmt::format("{:.0f} px", share * scale.most_px));
    }
  }
}

cv::Vec3b heat_colour(double value) {
  static const cv::Mat3b table = colour_table(cv::COLORMAP_INFERNO);
  return table(0, static_cast<int>(255.0 * std::clamp(value, 0.0, 1.0)));
}

}  // namespace striate::agent::pictures
