#include "app/mission_pictures.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "app/pictures/cycle_sheet.hpp"
#include "app/pictures/plan_picture.hpp"
#include "app/simulated_body.hpp"

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
  const double along_m = mission.judge() != nullptr ? mission.judge()->in_corridor().x_m
                                                    : mission.cycle().memory().progress_m();
  const std::string caption =
      pictures::cycle_caption(mission.cycle(), along_m, mission.executive().current_action());
  save(fmt::format("{}/overview_{:05d}.png", folder_, mission.cycles()),
       pictures::draw_cycle_sheet(mission.cycle(), mission.body().description(), mission.trail(),
                                  caption));
}

void MissionPictures::finish(const Mission& mission, const RunResult& result) const {
  const SimulatedBody* body = mission.simulated();
  if (folder_.empty() || body == nullptr) return;
  const std::string title =
      fmt::format("{}, seed {}: {} after {:.1f} m and {:.0f} s, nearest pass {:.2f} m",
                  body->world().name, result.seed, name_of(result.outcome), result.distance_m,
                  result.duration_s, result.nearest_pass_m);
  save(folder_ + "/plan.png",
       pictures::draw_plan(body->world(), body->plan(), body->judge(), &body->light(), title));
}

}  // namespace striate
