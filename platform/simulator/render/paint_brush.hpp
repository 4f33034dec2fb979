#pragma once

#include <opencv2/imgproc.hpp>
#include <string>

#include "striate/platform/simulator/render/noise.hpp"

namespace striate::simulator::render {

using cv::Point;
using cv::Scalar;

/// Draws random shapes whose kind, place and colour come from a counter.
class Brush {
 public:
  Brush(cv::Mat3b& picture, std::uint32_t seed) : picture_(picture), seed_(seed) {}
  float draw() { return uniform(mix(seed_, counter_++)); }
  int draw(int low, int high) {
    return low + static_cast<int>(draw() * static_cast<float>(high - low));
  }
  Point place() { return {draw(0, picture_.cols), draw(0, picture_.rows)}; }
  Scalar colour() { return Scalar(draw(20, 240), draw(20, 240), draw(20, 240)); }

  void write(const std::string& text, Point at, double size, const Scalar& ink, int thick = 2) {
    cv::putText(picture_, text, at, cv::FONT_HERSHEY_DUPLEX, size, ink, thick, cv::LINE_AA);
  }
  void lines_of_text(cv::Rect where, int step, const Scalar& ink) {
    for (int y = where.y; y < where.y + where.height; y += step) {
      int x = where.x;
      while (x < where.x + where.width - step) {
        const int word = draw(step / 2, step * 3);
        const int end = std::min(x + word, where.x + where.width);
        cv::line(picture_, {x, y}, {end, y}, ink, std::max(1, step / 3));
        x += word + step / 2;
      }
    }
  }
  void barcode(cv::Rect where) {
    cv::rectangle(picture_, where, Scalar(235, 235, 235), cv::FILLED);
    for (int x = where.x + 4; x < where.x + where.width - 6;) {
      const int wide = draw(1, 5);
      cv::rectangle(picture_, {x, where.y + 4, wide, where.height - 8}, Scalar(25, 25, 25),
                    cv::FILLED);
      x += wide + draw(2, 6);
    }
  }

 private:
  cv::Mat3b& picture_;
  std::uint32_t seed_;
  std::uint32_t counter_ = 0;
};

inline cv::Mat3b sheet(int width, int height, const Scalar& ground) {
  return cv::Mat3b(height, width,
                   cv::Vec3b(cv::saturate_cast<std::uint8_t>(ground[0]),
                             cv::saturate_cast<std::uint8_t>(ground[1]),
                             cv::saturate_cast<std::uint8_t>(ground[2])));
}

}  // namespace striate::simulator::render
