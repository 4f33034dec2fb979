#include "striate/agent/pictures/canvas.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace striate::agent::pictures {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;  // OpenCV's only plain letters
constexpr double kUnit = 0.5;                    // OpenCV's scale for 11 px capitals

}  // namespace

int text_width(const std::string& text, double size) {
  return cv::getTextSize(text, kFont, size * kUnit, 1, nullptr).width;
}

void write(cv::Mat3b& image, const std::string& text, cv::Point at, const cv::Scalar& colour,
           double size) {
  cv::putText(image, text, at, kFont, size * kUnit, colour, 1, cv::LINE_AA);
}

void write_label(cv::Mat3b& image, const std::string& text, cv::Point at,
                 const cv::Scalar& colour) {
  constexpr double kSize = 0.9;  // a little below the text's, of 10 px capitals on a plate of 17
  const cv::Size plate(text_width(text, kSize) + 8, 17);
  at.x = std::clamp(at.x, 0, std::max(0, image.cols - plate.width));
  at.y = std::clamp(at.y, 0, std::max(0, image.rows - plate.height));
  const cv::Rect box = cv::Rect(at, plate) & cv::Rect({0, 0}, image.size());
  cv::Mat3b under = image(box);
  under = under * 0.25;
  write(image, text, {at.x + 4, at.y + 13}, colour, kSize);
}

cv::Mat3b fit(const cv::Mat3b& image, cv::Size size) {
  cv::Mat3b out;
  if (image.empty()) return {size, cv::Vec3b(0, 0, 0)};
  const bool shrinks = image.cols > size.width;
  cv::resize(image, out, size, 0, 0, shrinks ? cv::INTER_AREA : cv::INTER_CUBIC);
  return out;
}

void tint(cv::Mat3b& image, const cv::Mat1b& mask, const cv::Scalar& colour, double opacity) {
  cv::Mat3b mixed;
  const cv::Mat3b flat(image.size(), cv::Vec3b(cv::saturate_cast<uchar>(colour[0]),
                                               cv::saturate_cast<uchar>(colour[1]),
                                               cv::saturate_cast<uchar>(colour[2])));
  cv::addWeighted(image, 1.0 - opacity, flat, opacity, 0.0, mixed);
  mixed.copyTo(image, mask);
}

}  // namespace striate::agent::pictures
