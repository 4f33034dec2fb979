#pragma once

#include <opencv2/imgproc.hpp>

namespace striate::reference {

struct EyeImages {
  cv::Mat1b left;
  cv::Mat1b right;
};

/// Patterned cards of many sizes at different distances, as two eyes side by side see them, with
/// the noise of two sensors. @param nearest_px, farthest_px disparities in images 640 px wide
inline EyeImages scattered_pair(std::uint64_t seed, double nearest_px = 60.0,
                                double farthest_px = 6.0, cv::Size size = {640, 480}) {
  constexpr int kCards = 220;
  cv::RNG random(seed);
  EyeImages eyes{cv::Mat1b(size, uchar{110}), cv::Mat1b(size, uchar{110})};
  for (int k = 0; k < kCards; ++k) {  // the farthest first, so that near ones hide them
    const double d_px =
        (farthest_px + (nearest_px - farthest_px) * k / kCards) * size.width / 640.0;
    const int side = 14 + static_cast<int>(random.uniform(0, 36));
    const cv::Rect card(random.uniform(-20, size.width + 20), random.uniform(-10, size.height),
                        side, 10 + side * random.uniform(3, 12) / 10);
    cv::Mat1b pattern(5, 5);  // no two cards are alike
    random.fill(pattern, cv::RNG::UNIFORM, 20, 235);
    cv::resize(pattern, pattern, card.size(), 0.0, 0.0, cv::INTER_CUBIC);
    const cv::Rect whole(0, 0, size.width, size.height);
    for (const bool is_right : {false, true}) {
      const cv::Rect there = card + cv::Point(is_right ? -cvRound(d_px) : 0, 0);
      const cv::Rect seen = there & whole;
      if (seen.empty()) continue;
      pattern(seen - there.tl()).copyTo((is_right ? eyes.right : eyes.left)(seen));
    }
  }
  for (cv::Mat1b* image : {&eyes.left, &eyes.right}) {
    cv::Mat1s noise(size);
    random.fill(noise, cv::RNG::NORMAL, 0.0, 2.0);
    cv::Mat1s sum;
    image->convertTo(sum, CV_16S);
    sum += noise;
    sum.convertTo(*image, CV_8U);
  }
  return eyes;
}

}  // namespace striate::reference
