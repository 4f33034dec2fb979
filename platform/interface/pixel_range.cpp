#include "striate/platform/interface/pixel_range.hpp"

#include <algorithm>
#include <opencv2/core.hpp>

namespace striate {

int bits_used(const cv::Mat& image) {
  constexpr int kFewest = 8;  // what is shown at last has no more
  constexpr int kMost = 16;   // bits of cv::Mat's CV_16U
  if (image.empty() || image.depth() != CV_16U) return kFewest;
  // A channel of transparency tells nothing of the others, which it exceeds.
  const int colours = image.channels() - (image.channels() % 2 == 0 ? 1 : 0);
  double most = 0.0;
  for (int channel = 0; channel < colours; ++channel) {
    cv::Mat one;
    cv::extractChannel(image, one, channel);
    double greatest = 0.0;
    cv::minMaxLoc(one, nullptr, &greatest);
    most = std::max(most, greatest);
  }
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
