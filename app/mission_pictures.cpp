#include "app/mission_pictures.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "app/pictures/canvas.hpp"
#include "app/pictures/disparity_colours.hpp"
#include "app/pictures/map_picture.hpp"
#include "app/pictures/plan_picture.hpp"
#include "app/pictures/scene_pictures.hpp"

namespace striate {
namespace {

constexpr int kGap = 8;
constexpr int kCaption = 40;
const cv::Size kLarge(640, 480);
const cv::Size kSmall(316, 237);
constexpr int kMapSide = 480;

void save(const std::string& file, const cv::Mat3b& picture) {
  bool written = false;
  try {
    written = cv::imwrite(file, picture);
  } catch (const cv::Exception&) {
    written = false;
  }
  if (!written) throw std::runtime_error(fmt::format("{}: the picture cannot be written", file));
}

void place(cv::Mat3b& page, const cv::Mat3b& tile, cv::Point at, const std::string& title) {
  tile.copyTo(page(cv::Rect(at, tile.size())));
  pictures::write_label(page, title, {at.x + 6, at.y + 6}, pictures::kInk);
}

std::string caption(const Mission& mission) {
  const CycleTrace& trace = mission.cycle().trace();
  const Pose2 place = mission.body().judge().in_corridor();
  return fmt::format("{:6.1f} s   {:5.1f} m along   {:.2f} m/s   {}: {}",
                     to_seconds(trace.senses.now), place.x_m, trace.senses.odometry.forward_m_s,
                     mission.executive().current_action(), trace.wish.why.view());
}

/// Camera with what stands in the way, disparity, saliency, and the map with the trail.
cv::Mat3b overview_of(const Mission& mission) {
  const CycleTrace& trace = mission.cycle().trace();
  const int map_left = kLarge.width + kSmall.width + 2 * kGap;
  cv::Mat3b page(kLarge.height + kCaption, map_left + kMapSide);
  page.setTo(pictures::kBackground);
  place(page, pictures::draw_obstacles(trace.senses.stereo, trace.percept, kLarge), {0, 0},
        "left eye: free floor, obstacles");
  const DisparityMap& disparity = trace.percept.disparity;
  place(page, pictures::colour_disparity(disparity, pictures::scale_for(disparity), kSmall),
        {kLarge.width + kGap, 0}, "disparity");
  place(page, pictures::draw_saliency(trace.senses.stereo, trace.percept, kSmall),
        {kLarge.width + kGap, kSmall.height + 6}, "saliency");
  place(page,
        pictures::draw_map(mission.cycle().memory(), mission.body().description(), mission.trail(),
                           kMapSide),
        {map_left, 0}, "short-term memory, 10 x 10 m");
  pictures::write(page, caption(mission), {10, kLarge.height + 26}, pictures::kInk, 1.1);
  return page;
}

}  // namespace

MissionPictures::MissionPictures(std::string folder, int every)
    : folder_(std::move(folder)), every_(every) {
  if (folder_.empty()) return;
  std::error_code code;
  std::filesystem::create_directories(folder_, code);
  if (code) {
    throw std::runtime_error(
        fmt::format("{}: the folder cannot be made: {}", folder_, code.message()));
  }
}

void MissionPictures::take(const Mission& mission) const {
  if (folder_.empty() || every_ <= 0 || mission.cycles() % static_cast<unsigned>(every_) != 0) {
    return;
  }
  if (!mission.cycle().trace().percept.valid) return;
  save(fmt::format("{}/overview_{:05d}.png", folder_, mission.cycles()), overview_of(mission));
}

void MissionPictures::finish(const Mission& mission, const RunResult& result) const {
  if (folder_.empty()) return;
  const std::string title = fmt::format(
      "{}, seed {}: {} after {:.1f} m and {:.0f} s, nearest pass {:.2f} m", mission.world().name,
      result.seed, result.outcome, result.distance_m, result.duration_s, result.nearest_pass_m);
  save(folder_ + "/plan.png", pictures::draw_plan(mission.world(), mission.plan(),
                                                  mission.body().judge(), &mission.light(), title));
}

}  // namespace striate
