#include "striate/agent/pictures/memory_pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <unordered_map>

#include "striate/agent/pictures/canvas.hpp"
#include "striate/base/index_within.hpp"
#include "striate/base/user_error.hpp"

namespace striate::agent::pictures {
namespace {

constexpr int kTile_px = 320;     // px: a view's longer side; three tiles fill the map's width
constexpr int kTilesInRow = 3;    // as wide as the map below
constexpr int kMapSide_px = 900;  // px: fits a full HD screen's height
constexpr int kWidestView_px = 1 << 14;  // px: the largest image that is read
constexpr int kMapMargin_px = 50;        // px around the map: labels at the border fit

cv::Mat3b draw_view(const memory::StoredView& view) {
  cv::Mat3b image;
  if (!view.image.empty()) image = cv::imdecode(view.image, cv::IMREAD_COLOR);
  const cv::Size size(round_within(view.width_px, 1, kWidestView_px),
                      round_within(view.height_px, 1, kWidestView_px));
  if (image.empty()) image = cv::Mat3b(kTile_px, kTile_px, cv::Vec3b(90, 90, 90));
  const double scale = std::min(static_cast<double>(kTile_px) / size.width,
                                static_cast<double>(kTile_px) / size.height);
  const cv::Size drawn(std::max(1, static_cast<int>(size.width * scale)),
                       std::max(1, static_cast<int>(size.height * scale)));
  cv::Mat3b tile(kTile_px, kTile_px, cv::Vec3b(30, 27, 25));
  cv::Mat3b inner =
      tile(cv::Rect({(kTile_px - drawn.width) / 2, (kTile_px - drawn.height) / 2}, drawn));
  fit(image, drawn).copyTo(inner);
  for (const perception::ViewKeypoint& point : view.keypoints) {
    const cv::Point at(cut_within((point.x_px + 0.5) * scale, -kTile_px, 2 * kTile_px),
                       cut_within((point.y_px + 0.5) * scale, -kTile_px, 2 * kTile_px));
    const int radius_px = cut_within(point.size_px * scale / 2.0, 2, 60);
    cv::circle(inner, at, radius_px, kFree, 1, cv::LINE_AA);
  }
  write_label(tile,
              fmt::format("view {}: {} keypoints{}", view.id, view.keypoints.size(),
                          view.damaged ? ", damaged" : ""),
              {6, 6}, view.damaged ? kBlocked : kInk);
  return tile;
}

/// From map to image.
struct Frame {
  double left_m = 0.0;
  double top_m = 0.0;
  double px_per_m = 1.0;
  cv::Size size;

  [[nodiscard]] cv::Point at(double x_m, double y_m) const {
    return {kMapMargin_px + drawn_px((x_m - left_m) * px_per_m),
            kMapMargin_px + drawn_px((top_m - y_m) * px_per_m)};
  }
};

Frame frame_around(const std::vector<memory::Landmark>& landmarks,
                   const std::vector<memory::ObstacleCell>& cells) {
  std::vector<cv::Point2d> points;
  for (const memory::Landmark& landmark : landmarks) {
    if (landmark.position) points.emplace_back(landmark.position->x_m, landmark.position->y_m);
  }
  for (const memory::ObstacleCell& cell : cells) {
    points.emplace_back(cell.column * memory::kObstacleCell_m, cell.row * memory::kObstacleCell_m);
  }
  if (points.empty()) {
    throw UserError("the map is empty: no landmark has a position yet, and no obstacle is kept");
  }
  auto [left, right] =
      std::minmax_element(points.begin(), points.end(), [](auto& a, auto& b) { return a.x < b.x; });
  auto [low, high] =
      std::minmax_element(points.begin(), points.end(), [](auto& a, auto& b) { return a.y < b.y; });
  const double width_m = std::max(1.0, right->x - left->x);
  const double height_m = std::max(1.0, high->y - low->y);
  Frame frame;
  frame.left_m = left->x;
  frame.top_m = high->y;
  frame.px_per_m = (kMapSide_px - 2 * kMapMargin_px) / std::max(width_m, height_m);
  frame.size = {2 * kMapMargin_px + cut_within(width_m * frame.px_per_m, 0, kMapSide_px) + 1,
                2 * kMapMargin_px + cut_within(height_m * frame.px_per_m, 60, kMapSide_px) + 1};
  return frame;
}

void draw_cells(cv::Mat3b& map, const Frame& frame,
                const std::vector<memory::ObstacleCell>& cells) {
  for (const memory::ObstacleCell& cell : cells) {
    const double x_m = cell.column * memory::kObstacleCell_m;
    const double y_m = cell.row * memory::kObstacleCell_m;
    cv::rectangle(map, frame.at(x_m, y_m),
                  frame.at(x_m + memory::kObstacleCell_m, y_m + memory::kObstacleCell_m),
                  cell.log_odds > 0.0 ? cv::Scalar(60, 60, 150) : cv::Scalar(50, 70, 45),
                  cv::FILLED);
  }
}

/// 95 % of a two-dimensional normal distribution lie within 2.45 standard deviations.
void draw_ellipse(cv::Mat3b& map, const Frame& frame, const memory::MapPosition& at) {
  const double mean = (at.var_x_m2 + at.var_y_m2) / 2.0;
  const double half = (at.var_x_m2 - at.var_y_m2) / 2.0;
  const double spread = std::hypot(half, at.cov_xy_m2);
  const double angle_rad = 0.5 * std::atan2(2.0 * at.cov_xy_m2, at.var_x_m2 - at.var_y_m2);
  const auto axis = [&](double variance) {
    return cut_within(2.45 * std::sqrt(std::max(0.0, variance)) * frame.px_per_m, 2,
                      2 * kMapSide_px);
  };
  cv::ellipse(map, frame.at(at.x_m, at.y_m), {axis(mean + spread), axis(mean - spread)},
              -angle_rad * 180.0 / std::numbers::pi, 0, 360, kCorridor, 1, cv::LINE_AA);
}

}  // namespace

cv::Mat3b draw_views(const memory::Landmark& landmark,
                     const std::vector<memory::StoredView>& views) {
  const int count = std::max<int>(1, static_cast<int>(views.size()));
  const int columns = std::min(count, kTilesInRow);
  const int rows = (count + columns - 1) / columns;
  cv::Mat3b sheet(rows * kTile_px + 30, columns * kTile_px, cv::Vec3b(30, 27, 25));
  write(sheet, landmark.name, {8, 21}, kInk);
  for (std::size_t k = 0; k < views.size(); ++k) {
    const cv::Point at(static_cast<int>(k) % columns * kTile_px,
                       30 + static_cast<int>(k) / columns * kTile_px);
    draw_view(views[k]).copyTo(sheet(cv::Rect(at, cv::Size(kTile_px, kTile_px))));
  }
  return sheet;
}

cv::Mat3b draw_memory_map(const std::vector<memory::Landmark>& landmarks,
                          const std::vector<memory::Route>& routes,
                          const std::vector<memory::ObstacleCell>& cells) {
  const Frame frame = frame_around(landmarks, cells);
  cv::Mat3b map(frame.size, cv::Vec3b(30, 27, 25));
  draw_cells(map, frame, cells);
  std::unordered_map<std::int64_t, cv::Point> places;
  for (const memory::Landmark& landmark : landmarks) {
    if (landmark.position) {
      places[landmark.id] = frame.at(landmark.position->x_m, landmark.position->y_m);
    }
  }
  for (const memory::Route& route : routes) {
    const auto from = places.find(route.from);
    const auto to = places.find(route.to);
    if (from == places.end() || to == places.end()) continue;
    cv::arrowedLine(map, from->second, to->second, kQuietInk, 1, cv::LINE_AA, 0, 0.04);
  }
  for (const memory::Landmark& landmark : landmarks) {
    if (!landmark.position) continue;
    draw_ellipse(map, frame, *landmark.position);
    cv::circle(map, places[landmark.id], 4, kFree, cv::FILLED, cv::LINE_AA);
    write_label(map, landmark.name, places[landmark.id] + cv::Point(7, -7), kInk);
  }
  const cv::Point origin(kMapMargin_px, frame.size.height - 16);
  cv::line(map, origin, origin + cv::Point(cut_within(frame.px_per_m, 0, kMapSide_px), 0), kInk, 2);
  write(map, "1 m", origin + cv::Point(4, -6), kInk);
  return map;
}

}  // namespace striate::agent::pictures
