#include "striate/app/recognised_thing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include "striate/app/recognised_picture.hpp"
#include "striate/base/geometry.hpp"
#include "striate/base/plain_text.hpp"
#include "striate/perception/recognition/region_depth.hpp"

namespace striate::app {
namespace {

using nlohmann::ordered_json;

ordered_json rounded_number(double value) {
  return std::round(value * 1e4) / 1e4;
}

}  // namespace

void add_range(const perception::DisparityMap& map, cv::Size picture, PlacedThing& placed) {
  cv::Point2d middle(0.0, 0.0);
  for (const cv::Point2d& corner : placed.thing.quad) middle += 0.25 * corner;
  const double small = static_cast<double>(map.disparity_px.cols) / picture.width;
  const double u = (middle.x + 0.5) * small - 0.5;
  placed.bearing_deg = degrees(std::atan2(map.centre_u_px - u, map.focal_px));
  cv::Rect2d box(middle.x, middle.y, 0.0, 0.0);
  for (const cv::Point2d& corner : placed.thing.quad) {
    const cv::Point2d half = middle + 0.5 * (corner - middle);
    const cv::Point2d low(std::min(box.x, half.x), std::min(box.y, half.y));
    const cv::Point2d high(std::max(box.br().x, half.x), std::max(box.br().y, half.y));
    box = {low, high};
  }
  box = {box.x * small, box.y * small, box.width * small, box.height * small};
  std::vector<float> buffer;
  const double disparity_px = perception::median_disparity_px(map, box, buffer);
  if (disparity_px > 0.0) placed.range_m = map.focal_px * map.baseline_m / disparity_px;
}

std::string thing_text(const PlacedThing& placed) {
  const agent::KnownThing& thing = placed.thing;
  cv::Point2d middle(0.0, 0.0);
  for (const cv::Point2d& corner : thing.quad) middle += 0.25 * corner;
  std::string text =
      fmt::format("  {} at ({:.0f}, {:.0f}), {} keypoints agree, scale {:.2f}",
                  plain_text(thing.name), middle.x, middle.y, thing.inliers, thing.scale);
  if (std::abs(thing.turned_rad) > radians(5.0)) {  // as much as a hand tilts a camera (ours)
    text += fmt::format(", turned {:.0f} deg", degrees(thing.turned_rad));
  }
  if (placed.range_m) text += fmt::format(", {:.2f} m away", *placed.range_m);
  return text + "\n";
}

ordered_json thing_json(const PlacedThing& placed) {
  const agent::KnownThing& thing = placed.thing;
  ordered_json quad = ordered_json::array();
  for (const cv::Point2d& corner : thing.quad) {
    quad.push_back({rounded_number(corner.x), rounded_number(corner.y)});
  }
  return {{"name", thing.name},
          {"view", thing.view},
          {"inliers", thing.inliers},
          {"score", rounded_number(thing.score)},
          {"matched", rounded_number(thing.matched)},
          {"scale", rounded_number(thing.scale)},
          {"turned_deg", rounded_number(degrees(thing.turned_rad))},
          {"quad", quad},
          {"range_m", placed.range_m ? rounded_number(*placed.range_m) : nullptr},
          {"bearing_deg", placed.bearing_deg ? rounded_number(*placed.bearing_deg) : nullptr}};
}

}  // namespace striate::app
