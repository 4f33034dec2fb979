#include "striate/evaluation/stereo_methods.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/ximgproc/disparity_filter.hpp>

#include "striate/base/index_within.hpp"
#include "striate/perception/stereo/stereo_matcher.hpp"

namespace striate::evaluation {
namespace {

StereoMethod ours(const std::string& name, perception::StereoMode mode, int width, int candidates) {
  perception::StereoSettings settings;
  settings.mode = mode;
  settings.width = width;
  settings.candidates = candidates;
  auto matcher = std::make_shared<perception::StereoMatcher>(settings);
  return {
      name,
      [matcher](const cv::Mat& left, const cv::Mat& right) { return matcher->match(left, right); },
      settings.wants_fine_greys()};
}

/// OpenCV does not search the first columns: continue the images to the left.
cv::Mat continued(const cv::Mat& image, int searched) {
  cv::Mat wide;
  cv::copyMakeBorder(image, wide, 0, 0, searched, 0, cv::BORDER_REPLICATE);
  return wide;
}

/// @param fixed sixteenths of a pixel, of images that were continued
perception::DisparityMap map_of(const cv::Mat1s& fixed, int searched) {
  perception::DisparityMap map;
  fixed.colRange(searched, fixed.cols).convertTo(map.disparity_px, CV_32F, 1.0 / 16.0);
  map.disparity_px.setTo(perception::kNoMatch, map.disparity_px < 0.0F);
  map.confidence = cv::Mat1f(map.disparity_px.size(), 1.0F);
  return map;
}

StereoMethod opencv(const std::string& name, const cv::Ptr<cv::StereoMatcher>& matcher) {
  return {name, [matcher](const cv::Mat& left, const cv::Mat& right) {
            const int searched = matcher->getNumDisparities();
            cv::Mat1s fixed;
            matcher->compute(continued(left, searched), continued(right, searched), fixed);
            cv::medianBlur(fixed, fixed, 5);
            return map_of(fixed, searched);
          }};
}

/// StereoSGBM in both directions, and what both say smoothed along the edges of the left image by
/// weighted least squares (Min et al. 2014), with the weights that OpenCV documents.
StereoMethod opencv_wls(const std::string& name, const cv::Ptr<cv::StereoMatcher>& matcher) {
  return {name, [matcher](const cv::Mat& left, const cv::Mat& right) {
            const int searched = matcher->getNumDisparities();
            const cv::Mat wide_left = continued(left, searched);
            const cv::Mat wide_right = continued(right, searched);
            const auto filter = cv::ximgproc::createDisparityWLSFilter(matcher);
            const auto backwards = cv::ximgproc::createRightMatcher(matcher);
            filter->setLambda(8000.0);
            filter->setSigmaColor(1.5);
            cv::Mat1s of_left, of_right, filtered;
            matcher->compute(wide_left, wide_right, of_left);
            backwards->compute(wide_right, wide_left, of_right);
            filter->filter(of_left, wide_left, filtered, of_right, {}, wide_right);
            return map_of(filtered, searched);
          }};
}

}  // namespace

std::vector<StereoMethod> stereo_methods(int width, int searched) {
  std::vector<StereoMethod> methods = {
      ours("paper", perception::StereoMode::paper, width, 0),
      ours("paper (K)", perception::StereoMode::paper, width, std::min(searched, 256)),
      ours("robust", perception::StereoMode::robust, width, std::min(searched, 256)),
      opencv("StereoBM 9", cv::StereoBM::create(searched, 9)),
  };
  const auto semi_global = [searched](int mode) {
    return cv::StereoSGBM::create(0, searched, 3, 8 * 9, 32 * 9, 1, 63, 10, 100, 2, mode);
  };
  for (const auto& [name, mode] : {std::pair{"SGBM", cv::StereoSGBM::MODE_SGBM},
                                   {"SGBM 3WAY", cv::StereoSGBM::MODE_SGBM_3WAY},
                                   {"SGBM HH", cv::StereoSGBM::MODE_HH}}) {
    methods.push_back(opencv(name, semi_global(mode)));
  }
  methods.push_back(opencv_wls("SGBM WLS", semi_global(cv::StereoSGBM::MODE_SGBM_3WAY)));
  return methods;
}

int disparities_to_search(const std::vector<StereoPair>& pairs) {
  double largest = 0.0;
  int least = 48;
  int widest = 0;
  for (const StereoPair& pair : pairs) {
    least = std::max(least, 48 * pair.left.cols / 160);
    widest = std::max(widest, pair.left.cols);  // what lies beyond is in no image
    for (int y = 0; y < pair.truth_px.rows; ++y) {
      for (int x = 0; x < pair.truth_px.cols; ++x) {
        if (std::isfinite(pair.truth_px(y, x))) {
          largest = std::max<double>(largest, pair.truth_px(y, x));
        }
      }
    }
  }
  const int wanted = ceil_within(largest, least - 2, std::max(least, widest) - 2) + 2;
  return (wanted + 15) / 16 * 16;
}

cv::Mat disturb(const cv::Mat& image) {
  const double level = image.depth() == CV_16U ? 16.0 : 1.0;
  cv::RNG random(7);
  cv::Mat1f noise(image.size()), result;
  random.fill(noise, cv::RNG::NORMAL, 0.0, 6.0 * level);
  image.convertTo(result, CV_32F, 1.3);
  result = cv::min(result + noise, 255.0 * level);
  cv::Mat grey;
  result.convertTo(grey, image.type());
  return grey;
}

EyeChange lowered_by(double rows_px) {
  return [rows_px](const cv::Mat& image) {
    const cv::Matx23d down(1.0, 0.0, 0.0, 0.0, 1.0, rows_px);
    cv::Mat lowered;
    cv::warpAffine(image, lowered, down, image.size(), cv::INTER_CUBIC, cv::BORDER_REPLICATE);
    const double white = image.depth() == CV_16U ? 16.0 * 255.0 : 255.0;
    return cv::Mat(cv::min(lowered, white));  // it overshoots beside edges
  };
}

StereoResult measure(const StereoMethod& method, const std::vector<StereoPair>& pairs,
                     const EyeChange& change) {
  StereoResult result;
  const double share = 1.0 / static_cast<double>(std::max<std::size_t>(1, pairs.size()));
  for (const StereoPair& pair : pairs) {
    const cv::Mat left = method.fine ? cv::Mat(pair.fine_left) : cv::Mat(pair.left);
    const cv::Mat right = method.fine ? cv::Mat(pair.fine_right) : cv::Mat(pair.right);
    const perception::DisparityMap map = method.match(left, change ? change(right) : right);
    const StereoScore score = judge(map.disparity_px, pair.truth_px);
    result.calibration.add(map.disparity_px, map.confidence, pair.truth_px);
    result.mean.bad1 += score.bad1 * share;
    result.mean.bad2 += score.bad2 * share;
    result.mean.density += score.density * share;
    result.of_pairs.push_back(score);
  }
  return result;
}

}  // namespace striate::evaluation
