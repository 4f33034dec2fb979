#include "striate/app/ros/replay_bag.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <stdexcept>

#include "striate/agent/mission.hpp"
#include "striate/agent/pictures/overview.hpp"
#include "striate/app/interrupt.hpp"
#include "striate/app/pair_watch.hpp"
#include "striate/app/perceive_files.hpp"
#include "striate/base/files.hpp"
#include "striate/base/say.hpp"
#include "striate/platform/ros/bag_robot.hpp"

namespace striate::app {
namespace {

using nlohmann::ordered_json;

ordered_json to_4_places(double value) {
  if (!std::isfinite(value)) return nullptr;
  return std::round(value * 1e4) / 1e4;
}

/// Share of the disparity map that has a trusted match.
double known_share(const perception::DisparityMap& map) {
  if (map.disparity_px.empty()) return 0.0;
  return cv::countNonZero(map.disparity_px < perception::kNoMatch) /
         static_cast<double>(map.disparity_px.total());
}

ordered_json line_of(const agent::CycleTrace& trace) {
  const Odometry& odometry = trace.senses.odometry;
  double nearest_m = perception::kNothing_m;
  for (const perception::Obstacle& one : trace.percept.obstacles) {
    nearest_m = std::min(nearest_m, one.distance_m);
  }
  return {{"time_s", to_4_places(to_seconds(trace.senses.now))},
          {"picture_s", to_4_places(to_seconds(trace.senses.stereo.stamp))},
          {"x_m", to_4_places(odometry.pose.x_m)},
          {"y_m", to_4_places(odometry.pose.y_m)},
          {"heading_rad", to_4_places(odometry.pose.heading_rad)},
          {"disparity_known", to_4_places(known_share(trace.percept.disparity))},
          {"obstacles", trace.percept.obstacles.size()},
          {"nearest_m", to_4_places(nearest_m)},
          {"salient_regions", trace.percept.saliency.regions.size()}};
}

/// Writes what is asked for, image pair by image pair.
class Notes {
 public:
  explicit Notes(const ReplayBagOptions& options) : options_(options) {
    if (options_.out.empty()) return;
    make_folder(options_.out);
    lines_.open(options_.out + "/percepts.jsonl");
  }
  void take(const agent::Mission& mission) {
    const agent::CycleTrace& trace = mission.cycle().trace();
    if (trace.senses.stereo.stamp == last_) return;
    last_ = trace.senses.stereo.stamp;
    ++pairs_;
    eyes_.take(trace.senses.stereo);
    tell(eyes_.news());
    if (options_.out.empty()) return;
    lines_ << line_of(trace).dump() << '\n';
    if (options_.picture_every > 0 && pairs_ % options_.picture_every == 0) {
      write_picture(fmt::format("{}/overview_{:05d}.png", options_.out, pairs_),
                    agent::pictures::draw_overview(trace.senses.stereo, trace.percept,
                                                   mission.body().description()));
    }
  }
  void finish() {
    tell(eyes_.finish());
    if (options_.out.empty() || lines_.flush()) return;
    throw std::runtime_error(options_.out + "/percepts.jsonl: cannot be written");
  }
  [[nodiscard]] int pairs() const { return pairs_; }

 private:
  static void tell(const std::string& wrong) {
    if (!wrong.empty()) say(stderr, wrong + "\n");
  }

  const ReplayBagOptions& options_;
  PairWatch eyes_;
  std::ofstream lines_;
  TimePoint last_{Duration::min()};
  int pairs_ = 0;
};

}  // namespace

int replay_bag(const ReplayBagOptions& options) {
  agent::MissionOptions asked;
  asked.robot = options.robot;
  ros::RosSettings read;
  const agent::BodySource bag{.wake = [&](const agent::RobotSettings& settings) -> agent::Body {
    auto robot = std::make_unique<ros::BagRobot>(options.bag, settings.ros,
                                                 agent::simulated_robot(settings), options.camera);
    read = robot->settings();
    return {.robot = std::move(robot), .place = options.bag};
  }};
  const Interrupt interrupt(Interrupt::BrokenOutput::ends);
  agent::Mission mission(asked, bag);
  Notes notes(options);
  const agent::RunResult result = mission.run([&](const agent::Mission& running) {
    notes.take(running);
    return Interrupt::requested();
  });
  notes.finish();
  if (result.outcome == agent::RunOutcome::lost) throw std::runtime_error(result.reason);
  fmt::print("{}: {} image pairs in {:.1f} s, {:.1f} m by odometry, {:.1f} ms a cycle\n",
             options.bag, notes.pairs(), result.duration_s, result.distance_m,
             result.mean_cycle_ms);
  fmt::print("  eyes {} and {}, odometry {}\n", read.left_image, read.right_image, read.odometry);
  // That a bag ends is no failure.
  return result.outcome == agent::RunOutcome::body_ended ? 0
                                                         : agent::row_of(result.outcome).exit_code;
}

}  // namespace striate::app
