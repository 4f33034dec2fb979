#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "perception/stereo/stereo_matcher.hpp"

namespace striate {

cv::Mat1b to_working_size(const cv::Mat& picture, int width) {
  if (picture.empty() || (picture.type() != CV_8UC3 && picture.type() != CV_8UC1)) {
    throw std::invalid_argument("to_working_size: wants an 8-bit BGR or grey picture");
  }
  if (width < 1) throw std::invalid_argument("to_working_size: the width must be at least 1");
  cv::Mat1b grey;
  if (picture.channels() == 3) {
    cv::cvtColor(picture, grey, cv::COLOR_BGR2GRAY);
  } else {
    grey = picture;
  }
  const double scale = static_cast<double>(width) / grey.cols;
  const int height = std::max(1, static_cast<int>(std::lround(grey.rows * scale)));
  if (grey.cols == width) return grey.clone();
  cv::Mat1b result;
  cv::resize(grey, result, {width, height}, 0, 0, scale < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
  return result;
}

}  // namespace striate
