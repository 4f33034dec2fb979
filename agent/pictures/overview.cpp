#include "striate/agent/pictures/overview.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

#include "striate/agent/pictures/canvas.hpp"
#include "striate/agent/pictures/disparity_colours.hpp"
#include "striate/agent/pictures/plan_of_columns.hpp"
#include "striate/agent/pictures/scene_pictures.hpp"

namespace striate::agent::pictures {
namespace {

constexpr int kTileGap_px = 10;  // px between tiles (ours)
constexpr int kTitle = 24;       // px above a tile: a line of text (ours)
constexpr int kFoot = 42;        // room below the sheet's tiles, for legend and facts
constexpr int kColumns = 3;      // tiles in a row: fills a screen of 16:9 (ours)

class Sheet {
 public:
  explicit Sheet(cv::Size tile)
      : tile_(tile),
        image_(2 * (kTitle + tile.height + kTileGap_px) + kTileGap_px + kFoot,
               kColumns * (tile.width + kTileGap_px) + kTileGap_px,
               cv::Vec3b(static_cast<uchar>(kBackground[0]), static_cast<uchar>(kBackground[1]),
                         static_cast<uchar>(kBackground[2]))) {}

  void place(int index, const std::string& title, const std::string& note, const cv::Mat3b& tile) {
    const cv::Point at = corner(index);
    tile.copyTo(image_(cv::Rect(at, tile_)));
    write(image_, title, {at.x + 1, at.y - 8}, kInk, 1.05);
    const int x = at.x + tile_.width - text_width(note, 0.85);
    write(image_, note, {x, at.y - 8}, kQuietInk, 0.85);
  }
  [[nodiscard]] cv::Point corner(int index) const {
    return {kTileGap_px + index % kColumns * (tile_.width + kTileGap_px),
            kTileGap_px + kTitle + index / kColumns * (kTitle + tile_.height + kTileGap_px) -
                kTileGap_px / 2};
  }
  [[nodiscard]] int foot() const { return image_.rows - kFoot + 2; }
  cv::Mat3b& image() { return image_; }

 private:
  cv::Size tile_;
  cv::Mat3b image_;
};

std::string disparity_note(const perception::DisparityMap& map) {
  if (map.disparity_px.empty()) return "";
  int known = 0;
  for (const float d : map.disparity_px) known += std::isfinite(d);
  return fmt::format("{} x {}, {:.0f} % known", map.disparity_px.cols, map.disparity_px.rows,
                     100.0 * known / static_cast<double>(map.disparity_px.total()));
}

std::string obstacle_note(const perception::Percept& percept, const char* unit) {
  if (percept.obstacles.empty()) return percept.columns.empty() ? "" : "nothing found";
  return fmt::format("{} found, nearest {:.2f} {}", percept.obstacles.size(),
                     percept.obstacles.front().distance_m, unit);
}

std::string corridor_note(const perception::CorridorView& view) {
  if (!view.valid) return "no corridor seen";
  const auto side = [](double m) {
    return std::isfinite(m) ? fmt::format("{:.2f} m", m) : std::string("?");
  };
  return fmt::format("corridor {:+.1f} deg, walls {} | {}", degrees(view.heading_rad),
                     side(view.left_m), side(view.right_m));
}

/// A round distance, about a third of the plan's reach.
double ring_for(double reach) {
  const double power = std::pow(10.0, std::floor(std::log10(reach / 3.0)));
  for (const double step : {5.0, 2.0}) {
    if (step * power <= reach / 2.5) return step * power;
  }
  return power;
}

cv::Mat3b missing(cv::Size size, const std::string& why) {
  cv::Mat3b tile(size, cv::Vec3b(38, 35, 33));
  const int x = (size.width - text_width(why)) / 2;
  write(tile, why, {x, size.height / 2}, kQuietInk);
  return tile;
}

}  // namespace

cv::Mat3b draw_overview(const StereoFrame& frame, const perception::Percept& percept,
                        const RobotDescription& robot, const OverviewStyle& style) {
  const double aspect =
      frame.left.empty() ? 0.75 : static_cast<double>(frame.left.rows) / frame.left.cols;
  const cv::Size tile(style.tile_width_px,
                      std::clamp(static_cast<int>(std::lround(style.tile_width_px * aspect)), 60,
                                 3 * style.tile_width_px));
  Sheet sheet(tile);
  const std::string size_note =
      frame.left.empty() ? "" : fmt::format("{} x {}", frame.left.cols, frame.left.rows);
  sheet.place(0, "Left", size_note,
              frame.left.empty() ? missing(tile, "no picture yet") : fit(frame.left, tile));
  sheet.place(1, "Right", size_note,
              frame.right.empty() ? missing(tile, "one eye only") : fit(frame.right, tile));
  const DisparityScale scale = scale_for(percept.disparity, style.metric);
  const bool depth = !percept.disparity.disparity_px.empty();
  sheet.place(2, "Disparity", disparity_note(percept.disparity),
              depth ? colour_disparity(percept.disparity, scale, tile)
                    : missing(tile, "needs two pictures"));
  sheet.place(3, "Obstacles", obstacle_note(percept, style.unit),
              draw_obstacles(frame, percept, tile, robot, style.unit));
  sheet.place(4, "Saliency", fmt::format("{} regions", percept.saliency.regions.size()),
              draw_saliency(frame, percept, tile));
  sheet.place(5, "Floor plan", corridor_note(percept.corridor),
              draw_plan_of_columns(percept, tile,
                                   {style.plan_reach, ring_for(style.plan_reach), style.unit}));

  cv::Mat3b& image = sheet.image();
  const int x = sheet.corner(0).x;
  write(image, "far", {x, sheet.foot() + 10}, kQuietInk, 0.85);
  if (depth) draw_legend(image, {x + 34, sheet.foot(), tile.width - 80, 11}, scale);
  write(image, "near", {x + tile.width - 38, sheet.foot() + 10}, kQuietInk, 0.85);
  write(image,
        fmt::format("light {:.0f} %   noise {:.1f} grey levels   keypoints {}",
                    100.0 * percept.light_level, percept.noise_level, percept.keypoints.size()),
        {sheet.corner(1).x, sheet.foot() + 10}, kQuietInk, 0.85);
  int key = sheet.corner(5).x;
  const auto explain = [&](const cv::Scalar& colour, const std::string& text) {
    cv::rectangle(image, {key, sheet.foot() + 1, 10, 10}, colour, cv::FILLED);
    write(image, text, {key + 15, sheet.foot() + 10}, kQuietInk, 0.85);
    key += 15 + text_width(text, 0.85) + 18;
  };
  explain(kFree * 0.75, "floor seen free");
  explain(kBlocked, "in the way");
  explain(kHidden, "hidden behind it");
  explain(kCorridor, "corridor");
  return image;
}

}  // namespace striate::agent::pictures
