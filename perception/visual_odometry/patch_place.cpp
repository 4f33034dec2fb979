#include "striate/perception/visual_odometry/patch_place.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace striate::perception {
namespace {

constexpr int kMostPatchSteps = 12;      // steps; from a keypoint five are usual
constexpr double kPatchStep_px = 0.005;  // below what noise leaves, a stop

constexpr int kHalf_px = 7;  // of the patch: 15 x 15 px on each level (see README)
constexpr int kSide_px = 2 * kHalf_px + 1;
constexpr int kWide_px = kSide_px + 2;  // with a border for the slopes
using PatchValues = std::array<float, static_cast<std::size_t>(kSide_px* kSide_px)>;

double on_level(double px, int level) {
  return std::ldexp(px + 0.5, -level) - 0.5;
}

double from_level(double px, int level) {
  return std::ldexp(px + 0.5, level) - 0.5;
}

/// Between four pixels. @return false: outside
bool sample(const cv::Mat1b& image, double u, double v, float& value) {
  const double left = std::floor(u), top = std::floor(v);
  if (!(left >= 0.0 && top >= 0.0 && left + 1.0 < image.cols && top + 1.0 < image.rows)) {
    return false;
  }
  const int x = static_cast<int>(left), y = static_cast<int>(top);
  const float a = static_cast<float>(u - left), b = static_cast<float>(v - top);
  const std::uint8_t* upper = image[y] + x;
  const std::uint8_t* lower = image[y + 1] + x;
  value = (1.0F - b) * ((1.0F - a) * upper[0] + a * upper[1]) +
          b * ((1.0F - a) * lower[0] + a * lower[1]);
  return true;
}

/// Mean 0 and length 1. @return the standard deviation before
double normalise(PatchValues& values) {
  double sum = 0.0, squares = 0.0;
  for (const float value : values) sum += value;
  const double mean = sum / static_cast<double>(values.size());
  for (float& value : values) {
    value -= static_cast<float>(mean);
    squares += static_cast<double>(value) * value;
  }
  if (squares > 0.0) {
    const float scale = static_cast<float>(1.0 / std::sqrt(squares));
    for (float& value : values) value *= scale;
  }
  return std::sqrt(squares / static_cast<double>(values.size()));
}

/// The patch that is looked for, as the image should show it.
struct Template {
  PatchValues values;            ///< mean 0, length 1
  PatchValues slope_u, slope_v;  ///< of these values
  double uu = 0.0, uv = 0.0, vv = 0.0;
  double contrast = 0.0;

  bool take(const cv::Mat1b& image, cv::Point2d at, const cv::Matx22d& back) {
    std::array<float, static_cast<std::size_t>(kWide_px * kWide_px)> wide;
    for (int y = 0; y < kWide_px; ++y) {
      for (int x = 0; x < kWide_px; ++x) {
        const double du = x - kHalf_px - 1, dv = y - kHalf_px - 1;
        if (!sample(image, at.x + back(0, 0) * du + back(0, 1) * dv,
                    at.y + back(1, 0) * du + back(1, 1) * dv,
                    wide[static_cast<std::size_t>(y * kWide_px + x)])) {
          return false;
        }
      }
    }
    std::size_t k = 0;
    for (int y = 1; y + 1 < kWide_px; ++y) {
      for (int x = 1; x + 1 < kWide_px; ++x, ++k) {
        const float* here = wide.data() + y * kWide_px + x;
        values[k] = here[0];
        slope_u[k] = 0.5F * (here[1] - here[-1]);
        slope_v[k] = 0.5F * (here[kWide_px] - here[-kWide_px]);
      }
    }
    contrast = normalise(values);
    if (!(contrast > 0.0)) return true;
    const float scale =
        static_cast<float>(1.0 / (contrast * std::sqrt(static_cast<double>(values.size()))));
    for (k = 0; k < values.size(); ++k) {
      slope_u[k] *= scale;
      slope_v[k] *= scale;
      uu += slope_u[k] * slope_u[k];
      uv += slope_u[k] * slope_v[k];
      vv += slope_v[k] * slope_v[k];
    }
    return true;
  }
};

bool take_patch(const cv::Mat1b& image, cv::Point2d at, PatchValues& values) {
  float* to = values.data();
  for (int dv = -kHalf_px; dv <= kHalf_px; ++dv) {
    for (int du = -kHalf_px; du <= kHalf_px; ++du) {
      if (!sample(image, at.x + du, at.y + dv, *to++)) return false;
    }
  }
  return true;
}

/// Steps to where the image is most like the patch.
PatchPlace follow(const Template& patch, const cv::Mat1b& image, cv::Point2d start,
                  const PatchSettings& settings) {
  PatchPlace place;
  const double determinant = patch.uu * patch.vv - patch.uv * patch.uv;
  place.result = PatchPlace::Result::without_contrast;
  // An edge says nothing along itself: its smaller eigenvalue is a hundredth of the larger (by
  // hand).
  constexpr double kEdge = 0.01;
  const double trace = patch.uu + patch.vv;
  if (!(determinant > kEdge * 0.25 * trace * trace)) return place;
  PatchValues seen;
  cv::Point2d at = start;
  double likeness = 0.0;
  for (int step = 0; step < kMostPatchSteps; ++step) {
    place.result = PatchPlace::Result::outside;
    if (!take_patch(image, at, seen)) return place;
    normalise(seen);
    double u = 0.0, v = 0.0;
    likeness = 0.0;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const float error = patch.values[k] - seen[k];
      u += error * patch.slope_u[k];
      v += error * patch.slope_v[k];
      likeness += patch.values[k] * seen[k];
    }
    const cv::Point2d by((patch.vv * u - patch.uv * v) / determinant,
                         (patch.uu * v - patch.uv * u) / determinant);
    at += by;
    place.result = PatchPlace::Result::unlike;
    const cv::Point2d away = at - start;
    if (!(away.dot(away) <= settings.most_shift_px * settings.most_shift_px)) return place;
    if (by.dot(by) < kPatchStep_px * kPatchStep_px) break;
  }
  if (likeness < settings.least_likeness) return place;
  return {PatchPlace::Result::found, at.x, at.y};
}

}  // namespace

void PicturePyramid::build(const cv::Mat1b& grey) {
  level[0] = grey.clone();  // whoever gave it may use its memory again
  for (std::size_t k = 1; k < level.size(); ++k) {
    const cv::Mat1b& wide = level[k - 1];
    const cv::Size half(std::max(1, wide.cols / 2), std::max(1, wide.rows / 2));
    const cv::Rect even(0, 0, std::min(wide.cols, 2 * half.width),
                        std::min(wide.rows, 2 * half.height));
    cv::Mat1b made;
    cv::resize(wide(even), made, half, 0, 0, cv::INTER_AREA);
    level[k] = made;
  }
}

PatchPlace find_patch(const PicturePyramid& reference, cv::Point2d at, const PicturePyramid& image,
                      cv::Point2d start, const cv::Matx22d& back, int level,
                      const PatchSettings& settings) {
  const auto index = static_cast<std::size_t>(std::clamp(level, 0, PicturePyramid::kLevels - 1));
  const int down = static_cast<int>(index);
  Template patch;
  if (!patch.take(reference.level[index], {on_level(at.x, down), on_level(at.y, down)}, back)) {
    return {};
  }
  if (patch.contrast < settings.least_contrast) {
    return {PatchPlace::Result::without_contrast, 0.0, 0.0};
  }
  PatchPlace place = follow(patch, image.level[index],
                            {on_level(start.x, down), on_level(start.y, down)}, settings);
  place.u_px = from_level(place.u_px, down);
  place.v_px = from_level(place.v_px, down);
  return place;
}

}  // namespace striate::perception
