#include "striate/agent/pictures/scene_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "striate/agent/pictures/canvas.hpp"
#include "striate/agent/pictures/disparity_colours.hpp"
#include "striate/base/index_within.hpp"
#include "striate/perception/obstacles/view_geometry.hpp"

namespace striate::agent::pictures {
namespace {

constexpr std::size_t kMostBoxes = 8;  // more than these hide the image
/// Brightness of the image under the drawing: lines stand out, things are seen (ours)
constexpr double kPlain = 0.75;

/// Level disparity of a thing seen at this bearing and distance: inverts level_point().
double level_disparity(const perception::ViewGeometry& geometry, const HeadPose& head,
                       const RobotDescription& robot, double bearing_rad, double distance_m) {
  const double forward_m = distance_m * std::cos(bearing_rad - head.pan_rad) -
                           robot.camera_forward_m * std::cos(head.pan_rad);
  return geometry.focal_baseline() / std::max(1e-6, forward_m);
}

cv::Mat1b free_mask(const perception::Percept& percept, const perception::ViewGeometry& geometry) {
  cv::Mat1b mask(percept.disparity.disparity_px.size(), uchar{0});
  for (int u = 0; u < mask.cols; ++u) {
    const perception::Column& c = percept.columns[u];
    for (int v = mask.rows - 1; v >= 0; --v) {
      const double d = geometry.floor_disparity_px(v);
      if (d <= 0.0) break;
      const perception::SpacePoint p = geometry.point(u, v, d);
      const double range_m = std::hypot(p.x_m, p.y_m);
      if (range_m >= c.free_from_m && range_m <= c.free_to_m) mask(v, u) = 255;
    }
  }
  return mask;
}

/// The pixels whose disparity is that of their column's obstacle.
cv::Mat1b standing_mask(const perception::Percept& percept,
                        const perception::ViewGeometry& geometry, const HeadPose& head,
                        const RobotDescription& robot) {
  const cv::Mat1f& disparity = percept.disparity.disparity_px;
  cv::Mat1b mask(disparity.size(), uchar{0});
  for (int u = 0; u < mask.cols; ++u) {
    const perception::Column& c = percept.columns[u];
    if (!std::isfinite(c.obstacle_m)) continue;
    const double level = level_disparity(geometry, head, robot, c.bearing_rad, c.obstacle_m);
    const double slack = std::max(1.0, 0.12 * level);
    for (int v = 0; v < mask.rows; ++v) {
      const double d = disparity(v, u);
      if (!std::isfinite(d) || std::abs(d * geometry.level_factor(v) - level) > slack) continue;
      if (d > geometry.floor_disparity_px(v) + 0.35) mask(v, u) = 255;
    }
  }
  return mask;
}

cv::Mat1b grow(const cv::Mat1b& mask, cv::Size size) {
  cv::Mat1b out;
  cv::resize(mask, out, size, 0, 0, cv::INTER_NEAREST);
  return out;
}

void draw_box(cv::Mat3b& image, const perception::Obstacle& o, const cv::Mat1b& standing,
              const char* unit) {
  const cv::Mat1b part = standing.colRange(o.from_u_px, o.to_u_px + 1);
  int top = part.rows;
  int bottom = -1;
  for (int v = 0; v < part.rows; ++v) {
    if (cv::countNonZero(part.row(v)) * 8 < part.cols) continue;  // stray pixels make no box
    top = std::min(top, v);
    bottom = v;
  }
  if (bottom < 0) return;
  const double scale_u = static_cast<double>(image.cols) / standing.cols;
  const double scale_v = static_cast<double>(image.rows) / standing.rows;
  const cv::Rect box(static_cast<int>(o.from_u_px * scale_u), static_cast<int>(top * scale_v),
                     static_cast<int>((o.to_u_px + 1 - o.from_u_px) * scale_u),
                     static_cast<int>((bottom + 1 - top) * scale_v));
  cv::rectangle(image, box, kBlocked, o.confidence > 0.5 ? 2 : 1, cv::LINE_AA);
  write_label(image, fmt::format("{:.1f} {}", o.distance_m, unit), {box.x + 2, box.y + 2}, kInk);
}

}  // namespace

cv::Mat3b draw_obstacles(const StereoFrame& frame, const perception::Percept& percept,
                         cv::Size size, const RobotDescription& robot, const char* unit) {
  cv::Mat3b image = fit(frame.left, size) * kPlain;
  if (percept.columns.empty() || percept.disparity.disparity_px.empty()) {
    write_label(image, "needs two pictures and a known camera", {12, 12}, kInk);
    return image;
  }
  const perception::ViewGeometry geometry(percept.disparity, frame.head, robot);
  const cv::Mat1b standing = standing_mask(percept, geometry, frame.head, robot);
  tint(image, grow(free_mask(percept, geometry), size), kFree, 0.35);
  tint(image, grow(standing, size), kBlocked, 0.30);
  const std::size_t boxes = std::min(kMostBoxes, percept.obstacles.size());
  for (std::size_t i = boxes; i-- > 0;) {  // nearest last, so that it lies on top
    draw_box(image, percept.obstacles[i], standing, unit);
  }
  return image;
}

cv::Mat3b draw_saliency(const StereoFrame& frame, const perception::Percept& percept,
                        cv::Size size) {
  const perception::SaliencyMap& saliency = percept.saliency;
  cv::Mat3b out = fit(frame.left, size);
  if (saliency.salience.empty()) {
    write_label(out, "not computed for this picture", {12, 12}, kInk);
    return out;
  }
  cv::Mat1f heat;
  cv::resize(saliency.salience, heat, size, 0, 0, cv::INTER_LINEAR);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      const cv::Vec3b hot = heat_colour(heat(v, u));
      const double opacity = 0.45 + 0.40 * heat(v, u);
      const cv::Vec3b& p = out(v, u);
      const double grey = 0.114 * p[0] + 0.587 * p[1] + 0.299 * p[2];
      for (int k = 0; k < 3; ++k) {
        out(v, u)[k] = cv::saturate_cast<uchar>((1.0 - opacity) * grey + opacity * hot[k]);
      }
    }
  }
  const double scale_u = static_cast<double>(size.width) / saliency.salience.cols;
  const double scale_v = static_cast<double>(size.height) / saliency.salience.rows;
  int number = 0;
  for (const perception::SalientRegion& r : saliency.regions) {
    const cv::Rect box(cut_within((r.u_px - 0.5 * r.width_px + 0.5) * scale_u, 0, out.cols),
                       cut_within((r.v_px - 0.5 * r.height_px + 0.5) * scale_v, 0, out.rows),
                       cut_within(r.width_px * scale_u, 0, out.cols),
                       cut_within(r.height_px * scale_v, 0, out.rows));
    cv::rectangle(out, box, {240, 240, 240}, 1, cv::LINE_AA);
    write_label(out, fmt::format("{}", ++number), {box.x + 2, box.y + 2}, kInk);
  }
  return out;
}

}  // namespace striate::agent::pictures
