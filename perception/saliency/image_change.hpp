#pragma once

#include <opencv2/core/mat.hpp>

namespace striate::perception {

/// Motion: change between consecutive images that one shift of the whole image does not
/// explain. Turning the head or the base shifts the image nearly uniformly; what is left belongs
/// to things that move by themselves, or is parallax. Ours.
class ImageChange {
 public:
  static constexpr int kLongestShift_px = 6;  ///< at this size

  /// Adds |grey now - grey before, shifted| in grey levels, less twice the median change (noise),
  /// to `sum`. Both CV_32F, of one size. The first image, or one of another size, adds nothing.
  void add(const cv::Mat1f& grey, cv::Mat1f& sum);
  /// The last shift: where a pixel of now was before, minus where it is.
  [[nodiscard]] cv::Point shift_px() const { return shift_px_; }

 private:
  void find_shift(const cv::Mat1f& grey);

  cv::Mat1f before_;
  cv::Mat1f change_, sorted_;
  cv::Point shift_px_;
};

}  // namespace striate::perception
