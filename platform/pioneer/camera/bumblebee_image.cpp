#include "striate/platform/pioneer/camera/bumblebee_image.hpp"

#include <opencv2/imgproc.hpp>

namespace striate::pioneer {

bool split_bumblebee(std::span<const std::uint8_t> raw, cv::Size size_px, cv::Mat3b& left,
                     cv::Mat3b& right) {
  const auto pixels = static_cast<std::size_t>(size_px.area());
  if (pixels == 0 || raw.size() != 2 * pixels) return false;
  cv::Mat1b left_bayer(size_px);
  cv::Mat1b right_bayer(size_px);
  for (std::size_t i = 0; i < pixels; ++i) {
    right_bayer.data[i] = raw[2 * i];
    left_bayer.data[i] = raw[2 * i + 1];
  }
  cv::cvtColor(left_bayer, left, cv::COLOR_BayerGRBG2BGR);
  cv::cvtColor(right_bayer, right, cv::COLOR_BayerGRBG2BGR);
  return true;
}

}  // namespace striate::pioneer
