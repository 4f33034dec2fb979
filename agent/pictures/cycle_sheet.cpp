#include "striate/agent/pictures/cycle_sheet.hpp"

#include <fmt/format.h>

#include "striate/agent/pictures/canvas.hpp"
#include "striate/agent/pictures/disparity_colours.hpp"
#include "striate/agent/pictures/map_picture.hpp"
#include "striate/agent/pictures/scene_pictures.hpp"

namespace striate::agent::pictures {
namespace {

constexpr int kGap = 8;       // px between tiles (ours)
constexpr int kCaption = 40;  // px above a tile: a line of text
const cv::Size kLarge(640, 480);
const cv::Size kSmall(316, 237);
constexpr int kMapSide = 480;  // px: as high as the large image

void place(cv::Mat3b& page, const cv::Mat3b& tile, cv::Point at, const std::string& title) {
  tile.copyTo(page(cv::Rect(at, tile.size())));
  write_label(page, title, {at.x + 6, at.y + 6}, kInk);
}

}  // namespace

cv::Mat3b draw_cycle_sheet(const CognitiveCycle& cycle, const RobotDescription& robot,
                           const std::deque<Point2>& trajectory, const std::string& caption) {
  const CycleTrace& trace = cycle.trace();
  const int map_left = kLarge.width + kSmall.width + 2 * kGap;
  cv::Mat3b page(kLarge.height + kCaption, map_left + kMapSide);
  page.setTo(kBackground);
  place(page, draw_obstacles(trace.senses.stereo, trace.percept, kLarge), {0, 0},
        "left eye: free floor, obstacles");
  const perception::DisparityMap& disparity = trace.percept.disparity;
  place(page, colour_disparity(disparity, scale_for(disparity), kSmall), {kLarge.width + kGap, 0},
        "disparity");
  place(page, draw_saliency(trace.senses.stereo, trace.percept, kSmall),
        {kLarge.width + kGap, kSmall.height + 6}, "saliency");
  place(page, draw_map(cycle.memory(), robot, trajectory, kMapSide), {map_left, 0},
        "short-term memory, 10 x 10 m");
  write(page, caption, {10, kLarge.height + 26}, kInk, 1.1);
  return page;
}

std::string cycle_caption(const CognitiveCycle& cycle, double along_m, std::string_view action) {
  const CycleTrace& trace = cycle.trace();
  return fmt::format("{:6.1f} s   {:5.1f} m along   {:.2f} m/s   {}: {}",
                     to_seconds(trace.senses.now), along_m, trace.senses.odometry.forward_m_s,
                     action, trace.wish.why.view());
}

}  // namespace striate::agent::pictures
