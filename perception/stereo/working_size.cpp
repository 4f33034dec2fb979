#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "striate/perception/stereo/shrink_by_four.hpp"
#include "striate/perception/stereo/stereo_matcher.hpp"

namespace striate::perception {
namespace {

cv::Mat1b grey_of(const cv::Mat& image, int width) {
  if (image.empty() || (image.type() != CV_8UC3 && image.type() != CV_8UC1)) {
    throw std::invalid_argument("to_working_size: wants an 8-bit BGR or grey image");
  }
  if (width < 1) throw std::invalid_argument("to_working_size: the width must be at least 1");
  if (image.channels() == 1) return image;
  cv::Mat1b grey;
  cv::cvtColor(image, grey, cv::COLOR_BGR2GRAY);
  return grey;
}

void resize_to(const cv::Mat& from, int width, cv::Mat& to) {
  const double scale = static_cast<double>(width) / from.cols;
  const int height = std::max(1, static_cast<int>(std::lround(from.rows * scale)));
  cv::resize(from, to, {width, height}, 0, 0, scale < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
}

}  // namespace

cv::Mat1b to_working_size(const cv::Mat& image, int width) {
  const cv::Mat1b grey = grey_of(image, width);
  if (grey.cols == width) return grey.clone();
  if (is_four_times(grey, width)) return means_of_fours(grey);
  cv::Mat1b result;
  resize_to(grey, width, result);
  return result;
}

cv::Mat1w to_fine_working_size(const cv::Mat& image, int width) {
  const cv::Mat1b grey = grey_of(image, width);
  if (is_four_times(grey, width)) return sums_of_fours(grey);
  cv::Mat1w fine;
  grey.convertTo(fine, CV_16U, 16.0);
  if (fine.cols == width) return fine;
  cv::Mat1w result;
  resize_to(fine, width, result);
  return result;
}

}  // namespace striate::perception
