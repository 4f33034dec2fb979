#include "app/mission_pictures.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "app/pictures/cycle_sheet.hpp"
#include "app/pictures/plan_picture.hpp"

namespace striate {
namespace {

void save(const std::string& file, const cv::Mat3b& picture) {
  bool written = false;
  try {
    written = cv::imwrite(file, picture);
  } catch (const cv::Exception&) {
    written = false;
  }
  if (!written) throw std::runtime_error(fmt::format("{}: the picture cannot be written", file));
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
  const std::string caption =
      pictures::cycle_caption(mission.cycle(), mission.body().judge().in_corridor().x_m,
                              mission.executive().current_action());
  save(fmt::format("{}/overview_{:05d}.png", folder_, mission.cycles()),
       pictures::draw_cycle_sheet(mission.cycle(), mission.body().description(), mission.trail(),
                                  caption));
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
