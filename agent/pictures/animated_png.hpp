#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace striate::agent::pictures {

/// A moving picture that browsers show: frames of one size, one after the other, for ever (APNG,
/// W3C PNG Specification, third edition, section 11.3.7). A reader that does not know it shows the
/// first.
class AnimatedPng {
 public:
  /// @param delay_ms how long each frame is shown, 1 .. 65535
  explicit AnimatedPng(int delay_ms) : delay_ms_(delay_ms) {}

  /// Whether a frame has the size of the first.
  [[nodiscard]] bool fits(const cv::Mat3b& frame) const {
    return !frame.empty() && (frames_.empty() || frame.size() == size_);
  }
  /// Adds a frame. @throws std::invalid_argument for one that does not fit
  void add(const cv::Mat3b& frame);
  [[nodiscard]] std::size_t frames() const { return frames_.size(); }
  /// The whole file. @throws std::logic_error without a frame
  [[nodiscard]] std::string bytes() const;

 private:
  int delay_ms_;
  cv::Size size_;
  std::string header_;               ///< IHDR's content, the same for all frames
  std::vector<std::string> frames_;  ///< compressed rows of each: what IDAT holds
};

}  // namespace striate::agent::pictures
