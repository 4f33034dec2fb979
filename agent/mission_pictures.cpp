#include "striate/agent/mission_pictures.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "striate/agent/pictures/cycle_sheet.hpp"
#include "striate/agent/pictures/plan_picture.hpp"
#include "striate/agent/simulated_body.hpp"
#include "striate/base/files.hpp"

namespace striate::agent {
namespace {

void save(const std::string& file, const cv::Mat3b& image) {
  bool written = false;
  try {
    written = cv::imwrite(file, image);
  } catch (const cv::Exception&) {
    written = false;
  }
  if (!written) throw std::runtime_error(fmt::format("{}: the picture cannot be written", file));
}

constexpr int kFilmWidth_px = 560;        // fits a column of text on a screen (ours)
constexpr int kFilmDelay_ms = 400;        // long enough to look at a frame (ours)
constexpr std::size_t kMostFrames = 600;  // four minutes of film; 30 MB in memory (ours)

/// Small, and of few colours: noise of the camera would make most of the file.
cv::Mat3b film_frame(const cv::Mat3b& sheet) {
  constexpr int kLevels = 16;  // steps between two shades of a channel (ours)
  cv::Mat3b frame;
  const int height_px = sheet.rows * kFilmWidth_px / sheet.cols;
  cv::resize(sheet, frame, {kFilmWidth_px, height_px}, 0, 0, cv::INTER_AREA);
  for (cv::Vec3b& pixel : frame) {
    for (int channel = 0; channel < 3; ++channel) {
      pixel[channel] =
          cv::saturate_cast<std::uint8_t>((pixel[channel] / kLevels) * kLevels + kLevels / 2);
    }
  }
  return frame;
}

}  // namespace

MissionPictures::MissionPictures(std::string folder, int every)
    : folder_(std::move(folder)), every_(every), film_(kFilmDelay_ms) {
  if (folder_.empty()) return;
  std::error_code code;
  std::filesystem::create_directories(folder_, code);
  if (code) {
    throw std::runtime_error(
        fmt::format("{}: the folder cannot be made: {}", folder_, code.message()));
  }
}

void MissionPictures::take(const Mission& mission) {
  if (folder_.empty() || every_ <= 0 || mission.cycles() % static_cast<unsigned>(every_) != 0) {
    return;
  }
  if (!mission.cycle().trace().percept.valid) return;
  const double along_m = mission.judge() != nullptr ? mission.judge()->in_corridor().x_m
                                                    : mission.cycle().memory().progress_m();
  const std::string caption =
      pictures::cycle_caption(mission.cycle(), along_m, mission.executive().current_action());
  const cv::Mat3b sheet = pictures::draw_cycle_sheet(mission.cycle(), mission.body().description(),
                                                     mission.trajectory(), caption);
  save(fmt::format("{}/overview_{:05d}.png", folder_, mission.cycles()), sheet);
  const cv::Mat3b frame = film_frame(sheet);
  if (film_.frames() < kMostFrames && film_.fits(frame)) film_.add(frame);
}

void MissionPictures::finish(const Mission& mission, const RunResult& result) const {
  if (film_.frames() > 1) write_file(folder_ + "/film.png", film_.bytes());
  const SimulatedBody* body = mission.simulated();
  if (folder_.empty() || body == nullptr) return;
  const std::string title =
      fmt::format("{}, seed {}: {} after {:.1f} m and {:.0f} s, nearest pass {:.2f} m",
                  body->world().name, result.seed, name_of(result.outcome), result.distance_m,
                  result.duration_s, result.nearest_pass_m);
  save(folder_ + "/plan.png",
       pictures::draw_plan(simulator::world_without(body->world(), body->late_obstacles().absent()),
                           body->plan(), body->judge(), &body->light(), title));
}

}  // namespace striate::agent
