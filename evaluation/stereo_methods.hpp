#pragma once

#include <functional>
#include <string>
#include <vector>

#include "striate/evaluation/stereo_pairs.hpp"
#include "striate/evaluation/stereo_score.hpp"
#include "striate/perception/percept.hpp"

namespace striate::evaluation {

struct StereoMethod {
  std::string name;
  std::function<perception::DisparityMap(const cv::Mat& left, const cv::Mat& right)> match;
  bool fine = false;  ///< takes images in sixteenths of a grey level
};

/// The paper and the robust setting, and OpenCV's StereoBM and StereoSGBM (SGBM, 3WAY, HH; block
/// 3), which search the first `searched` disparities; "paper" searches the paper's 150 at width
/// 160, in scale, "paper (K)" as many as the others. OpenCV's images are continued to the left,
/// so that they search every column, and get a 5x5 median. Confidence is 1 where a method has none.
/// @param searched a multiple of 16.
[[nodiscard]] std::vector<StereoMethod> stereo_methods(int width, int searched);

/// The smallest multiple of 16 that covers all true disparities, at least 48 at width 160.
[[nodiscard]] int disparities_to_search(const std::vector<StereoPair>& pairs);

/// What is done to the right image before it is matched.
/// @param image 8 bits, or 16 in sixteenths of a level; the result is of the same kind.
using EyeChange = std::function<cv::Mat(const cv::Mat& image)>;

/// Another exposure and noise, as for one of the two eyes: gain 1.3, sigma 6 grey levels.
[[nodiscard]] cv::Mat disturb(const cv::Mat& image);

/// As by an eye whose rows lie higher: it shows things so many rows lower.
[[nodiscard]] EyeChange lowered_by(double rows_px);

struct StereoResult {
  std::vector<StereoScore> of_pairs;
  StereoScore mean;
  Calibration calibration;
};

[[nodiscard]] StereoResult measure(const StereoMethod& method, const std::vector<StereoPair>& pairs,
                                   const EyeChange& change = nullptr);

}  // namespace striate::evaluation
