#include "striate/perception/recognition/look_windows.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "striate/base/index_within.hpp"

namespace striate::perception {
namespace {

/// Of the image's sides.
/// Of the image's sides, about a factor 1.5 apart (ours)
constexpr std::array<double, LookWindows::kSizes> kShares = {0.2, 0.3, 0.45, 0.7, 1.0};
/// Of a box that a window has: then looking again would cost more than it finds (ours)
constexpr double kMostlyCovered = 0.8;

int side_px(int image_px, int size) {
  return std::max(1, static_cast<int>(std::lround(kShares[static_cast<std::size_t>(size)] *
                                                  static_cast<double>(image_px))));
}

int begin_of(double middle_px, int side, int image_px) {
  return round_within(middle_px - 0.5 * side, 0, image_px - side);
}

}  // namespace

void LookWindows::begin(cv::Size image, int most) {
  image_ = image;
  most_ = static_cast<std::size_t>(most);
  windows_.clear();
}

void LookWindows::add(const cv::Rect2d& box) {
  const cv::Rect2d seen = box & cv::Rect2d(0.0, 0.0, image_.width, image_.height);
  if (windows_.size() >= most_ || !(seen.area() > 0.0)) return;
  const bool known = std::ranges::any_of(windows_, [&](const LookWindow& window) {
    return (cv::Rect2d(window.part) & seen).area() >= kMostlyCovered * seen.area();
  });
  if (known) return;
  int size = 0;
  while (size + 1 < kSizes &&
         (side_px(image_.width, size) < seen.width || side_px(image_.height, size) < seen.height)) {
    ++size;
  }
  const int width = side_px(image_.width, size), height = side_px(image_.height, size);
  windows_.push_back({{begin_of(seen.x + seen.width / 2, width, image_.width),
                       begin_of(seen.y + seen.height / 2, height, image_.height), width, height},
                      size});
}

bool LookWindows::covered(double u_px, double v_px, std::size_t count) const {
  return std::any_of(windows_.begin(), windows_.begin() + static_cast<std::ptrdiff_t>(count),
                     [&](const LookWindow& window) {
                       return u_px >= window.part.x && v_px >= window.part.y &&
                              u_px < window.part.x + window.part.width &&
                              v_px < window.part.y + window.part.height;
                     });
}

}  // namespace striate::perception
