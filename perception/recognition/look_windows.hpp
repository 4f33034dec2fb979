#pragma once

#include <opencv2/core/types.hpp>
#include <vector>

namespace striate::perception {

/// A part of the image to be looked at closely.
struct LookWindow {
  cv::Rect part;  ///< within the image
  int size = 0;   ///< 0 .. LookWindows::kSizes - 1: all windows of one size are equally large
};

/// Chooses windows around regions. A window has one of five sizes, a fixed share of the image
/// each: what works on them finds buffers of the right size and need not allocate.
class LookWindows {
 public:
  /// About a factor 1.5 apart, from a fifth of the image to all of it (kShares)
  static constexpr int kSizes = 5;

  void begin(cv::Size image, int most);
  /// Adds a window around `box` (pixels of the image; may reach beyond it) unless most of it is
  /// looked at already or there are enough.
  void add(const cv::Rect2d& box);
  [[nodiscard]] const std::vector<LookWindow>& windows() const { return windows_; }
  /// Whether a pixel lies in one of the first `count` windows.
  [[nodiscard]] bool covered(double u_px, double v_px, std::size_t count) const;

 private:
  cv::Size image_;
  std::size_t most_ = 0;
  std::vector<LookWindow> windows_;
};

}  // namespace striate::perception
