#include "striate/app/recognised_picture.hpp"

#include <fmt/format.h>

#include <opencv2/imgproc.hpp>

#include "striate/agent/pictures/canvas.hpp"
#include "striate/agent/pictures/label_places.hpp"
#include "striate/base/plain_text.hpp"

namespace striate::app {
namespace {

/// BGR, told apart from each other and from most things (ours)
const cv::Scalar kFrames[] = {{80, 220, 80},  {60, 160, 255}, {255, 160, 60},
                              {220, 80, 220}, {80, 220, 220}, {80, 80, 255}};

std::vector<cv::Point> drawn_quad(const agent::KnownThing& thing) {
  std::vector<cv::Point> points;
  for (const cv::Point2d& corner : thing.quad) {
    points.emplace_back(agent::pictures::drawn_px(corner.x), agent::pictures::drawn_px(corner.y));
  }
  return points;
}

}  // namespace

cv::Mat3b draw_recognised(const cv::Mat3b& picture, const std::vector<PlacedThing>& things) {
  cv::Mat3b image = picture.clone();
  agent::pictures::LabelPlaces places(image.size());
  for (std::size_t k = 0; k < things.size(); ++k) {
    cv::polylines(image, drawn_quad(things[k].thing), true, kFrames[k % std::size(kFrames)], 2,
                  cv::LINE_AA);
  }
  for (std::size_t k = 0; k < things.size(); ++k) {
    const agent::KnownThing& thing = things[k].thing;
    std::string text = fmt::format("{} ({})", plain_text(thing.name), thing.inliers);
    if (things[k].range_m) text += fmt::format(" {:.2f} m", *things[k].range_m);
    const cv::Size label(agent::pictures::text_width(text) + 8, 18);
    const std::vector<cv::Point> quad = drawn_quad(thing);
    const cv::Rect box = cv::boundingRect(quad) & cv::Rect(0, 0, image.cols, image.rows);
    const cv::Rect at = places.take({box.x, box.y}, label);
    agent::pictures::write_label(image, text, at.tl(), kFrames[k % std::size(kFrames)]);
  }
  return image;
}

}  // namespace striate::app
