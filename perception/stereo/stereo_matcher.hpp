#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>

#include "striate/perception/percept.hpp"
#include "striate/perception/stereo/stereo_settings.hpp"

namespace striate::perception {

/// A image at the working size: grey, `width` wide, height in proportion, every working pixel
/// the mean of the area that it covers. Smaller images are enlarged linearly.
/// @param image 8 bit, BGR or grey; else std::invalid_argument.
[[nodiscard]] cv::Mat1b to_working_size(const cv::Mat& image, int width);

/// The same in sixteenths of a grey level, 0..4080: the mean of many pixels is not rounded to 8
/// bits.
[[nodiscard]] cv::Mat1w to_fine_working_size(const cv::Mat& image, int width);

/// Dense disparity from V1 descriptors.
///
/// paper (the paper's section on stereo): descriptors at every pixel, lambda = 4, each left pixel
/// against K pixels of the right image from the same column leftwards, smallest Hamming
/// distance wins (of equal ones the smallest disparity), 5x5 median. Every pixel has a disparity;
/// confidence is 1 everywhere, for the paper has none.
///
/// robust: descriptors of the same 256 bits, from the simple cells' phase (see phase_code.hpp),
/// semi-global smoothing of their Hamming costs (Hirschmueller 2008), sub-pixel, and rejection:
/// left-right check, least confidence, speckles. What is rejected is kNoMatch, but for small gaps,
/// which their neighbours fill. Confidence is the share of such disparities that are right within
/// 1 px (StereoConfidence::promise).
///
/// Integer arithmetic up to the cost volume's minimum: the same result on every machine. Buffers
/// are kept: after the first pair of a size nothing is allocated. Not for concurrent use; any
/// number of matchers may work side by side.
class StereoMatcher {
 public:
  /// Throws UserError for settings out of range.
  explicit StereoMatcher(const StereoSettings& settings);
  ~StereoMatcher();
  StereoMatcher(StereoMatcher&&) noexcept;
  StereoMatcher& operator=(StereoMatcher&&) noexcept;

  /// @param left, right rectified, at the working size, same size; of to_working_size or both of
  /// to_fine_working_size; else std::invalid_argument.
  /// @return disparity in pixels of that size in the left image's frame; the camera fields
  /// (focal_px ...) are left for the caller, who knows the camera.
  [[nodiscard]] DisparityMap match(const cv::Mat& left, const cv::Mat& right);

  /// The same into `out`, whose matrices are used again where they fit.
  void match(const cv::Mat& left, const cv::Mat& right, DisparityMap& out);

  [[nodiscard]] const StereoSettings& settings() const;

 private:
  class Work;
  std::unique_ptr<Work> work_;
};

}  // namespace striate::perception
