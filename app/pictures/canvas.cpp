#include "app/pictures/canvas.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace striate::pictures {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;  // OpenCV's only plain letters
constexpr double kUnit = 0.5;                    // OpenCV's scale for 11 px capitals

}  // namespace

int text_width(const std::string& text, double size) {
  return cv::getTextSize(text, kFont, size * kUnit, 1, nullptr).width;
}

void write(cv::Mat3b& picture, const std::string& text, cv::Point at, const cv::Scalar& colour,
           double size) {
  cv::putText(picture, text, at, kFont, size * kUnit, colour, 1, cv::LINE_AA);
}

void write_label(cv::Mat3b& picture, const std::string& text, cv::Point at,
                 const cv::Scalar& colour) {
  constexpr double kSize = 0.9;  // a little below the text's, of 10 px capitals on a plate of 17
  const cv::Size plate(text_width(text, kSize) + 8, 17);
  at.x = std::clamp(at.x, 0, std::max(0, picture.cols - plate.width));
  at.y = std::clamp(at.y, 0, std::max(0, picture.rows - plate.height));
  const cv::Rect box = cv::Rect(at, plate) & cv::Rect({0, 0}, picture.size());
  cv::Mat3b under = picture(box);
  under = under * 0.25;
  write(picture, text, {at.x + 4, at.y + 13}, colour, kSize);
}

cv::Mat3b fit(const cv::Mat3b& picture, cv::Size size) {
  cv::Mat3b out;
  if (picture.empty()) return {size, cv::Vec3b(0, 0, 0)};
  const bool shrinks = picture.cols > size.width;
  cv::resize(picture, out, size, 0, 0, shrinks ? cv::INTER_AREA : cv::INTER_CUBIC);
  return out;
}

void tint(cv::Mat3b& picture, const cv::Mat1b& mask, const cv::Scalar& colour, double opacity) {
  cv::Mat3b mixed;
  const cv::Mat3b flat(picture.size(), cv::Vec3b(cv::saturate_cast<uchar>(colour[0]),
                                                 cv::saturate_cast<uchar>(colour[1]),
                                                 cv::saturate_cast<uchar>(colour[2])));
  cv::addWeighted(picture, 1.0 - opacity, flat, opacity, 0.0, mixed);
  mixed.copyTo(picture, mask);
}

}  // namespace striate::pictures
