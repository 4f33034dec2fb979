#include "striate/platform/interface/pixel_range.hpp"

#include <opencv2/core.hpp>

namespace striate {

int bits_used(const cv::Mat& image) {
  constexpr int kFewest = 8;  // what is shown at last has no more
  constexpr int kMost = 16;   // bits of cv::Mat's CV_16U
  if (image.empty() || image.depth() != CV_16U) return kFewest;
  double most = 0.0;
  cv::minMaxLoc(image.reshape(1), nullptr, &most);
  int bits = kFewest;
  while (bits < kMost && most > most_of_bits(bits)) bits += 2;
  return bits;
}

cv::Mat as_eight_bits(const cv::Mat& image, int most) {
  constexpr int kAll = 255;  // the most that CV_8U holds
  if (image.depth() == CV_8U && most == kAll) return image;
  cv::Mat bytes;
  image.convertTo(bytes, CV_8U, static_cast<double>(kAll) / most);
  return bytes;
}

}  // namespace striate
