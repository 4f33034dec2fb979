#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "perception/stereo/shrink_by_four.hpp"
#include "perception/stereo/stereo_matcher.hpp"

namespace striate {
namespace {

cv::Mat1b grey_of(const cv::Mat& picture, int width) {
  if (picture.empty() || (picture.type() != CV_8UC3 && picture.type() != CV_8UC1)) {
    throw std::invalid_argument("to_working_size: wants an 8-bit BGR or grey picture");
  }
  if (width < 1) throw std::invalid_argument("to_working_size: the width must be at least 1");
  if (picture.channels() == 1) return picture;
  cv::Mat1b grey;
  cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

void resize_to(const cv::Mat& from, int width, cv::Mat& to) {
  const double scale = static_cast<double>(width) / from.cols;
  const int height = std::max(1, static_cast<int>(std::lround(from.rows * scale)));
  cv::resize(from, to, {width, height}, 0, 0, scale < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
}

}  // namespace

cv::Mat1b to_working_size(const cv::Mat& picture, int width) {
  const cv::Mat1b grey = grey_of(picture, width);
  if (grey.cols == width) return grey.clone();
  if (is_four_times(grey, width)) return means_of_fours(grey);
  cv::Mat1b result;
  resize_to(grey, width, result);
  return result;
}

cv::Mat1w to_fine_working_size(const cv::Mat& picture, int width) {
  const cv::Mat1b grey = grey_of(picture, width);
  if (is_four_times(grey, width)) return sums_of_fours(grey);
  cv::Mat1w fine;
  grey.convertTo(fine, CV_16U, 16.0);
  if (fine.cols == width) return fine;
  cv::Mat1w result;
  resize_to(fine, width, result);
  return result;
}

}  // namespace striate
