#include "striate/app/sequence_odometry.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "striate/app/perceive_sequence.hpp"
#include "striate/base/files.hpp"
#include "striate/base/geometry.hpp"
#include "striate/evaluation/odometry/sequence_views.hpp"
#include "striate/perception/visual_odometry/visual_odometry.hpp"
#include "striate/platform/datasets/sequences/picture_list.hpp"

namespace striate::app {
namespace {

using nlohmann::ordered_json;

/// Standard deviation over the axes together; NaN where nothing was measured.
double spread_of(const cv::Matx66d& covariance, int from) {
  return std::sqrt(covariance(from, from) + covariance(from + 1, from + 1) +
                   covariance(from + 2, from + 2));
}

ordered_json json_of_view(const perception::VisualPose& pose, const evaluation::SequenceView& view,
                          const datasets::TimedPose& at) {
  ordered_json json = {{"number", view.number}, {"name", view.name}};
  json["stamp_ns"] = view.stamp_ns ? ordered_json(*view.stamp_ns) : ordered_json(nullptr);
  json["reason"] = perception::word_of(pose.reason);
  json["begun_anew"] = pose.begun_anew;
  json["keyframe"] = pose.keyframe;
  json["points"] = pose.points;
  json["matches"] = pose.matches;
  json["agreeing"] = pose.agreeing;
  if (!pose.known() && pose.reason != perception::NoEstimate::beginning) return json;
  const cv::Vec4d q = datasets::quaternion_of(at.rotation);
  json["position_m"] = {at.position_m[0], at.position_m[1], at.position_m[2]};
  json["quaternion_xyzw"] = {q[0], q[1], q[2], q[3]};
  json["noise_px"] = pose.noise_px;
  json["from_keyframe_sigma_m"] = spread_of(pose.covariance, 0);
  json["from_keyframe_sigma_deg"] = degrees(spread_of(pose.covariance, 3));
  return json;
}

std::string text_of_view(const perception::VisualPose& pose, const evaluation::SequenceView& view,
                         const datasets::TimedPose& at) {
  const std::string anew =
      pose.begun_anew ? "; goes on from the last place, the way is unknown" : "";
  if (!pose.known()) {
    return fmt::format("{:6} {}: {}{}\n", view.number, view.name, text_of(pose.reason), anew);
  }
  return fmt::format("{:6} {}: {:.3f} {:.3f} {:.3f} m, +-{:.4f} m +-{:.3f} deg, {} points{}\n",
                     view.number, view.name, at.position_m[0], at.position_m[1], at.position_m[2],
                     spread_of(pose.covariance, 0), degrees(spread_of(pose.covariance, 3)),
                     pose.agreeing, pose.keyframe ? ", keyframe" : "");
}

/// What is counted over all views.
struct OdometryCount {
  std::size_t views = 0, known = 0, begun_anew = 0;
  double way_m = 0.0;

  [[nodiscard]] std::string text() const {
    return fmt::format("{} views, {} with an estimate, {:.2f} m of way, begun anew {} times\n",
                       views, known, way_m, begun_anew);
  }
  [[nodiscard]] ordered_json json() const {
    return {{"views", views}, {"known", known}, {"way_m", way_m}, {"begun_anew", begun_anew}};
  }
};

}  // namespace

bool is_sequence(const std::string& path) {
  std::error_code error;
  return std::filesystem::is_directory(path, error) || datasets::is_video(path);
}

int tell_odometry(const SequenceOdometryOptions& options) {
  check_writable(options.out);
  const auto sequence = datasets::open_sequence(options.source, options.sequence);
  tell_sequence(*sequence);
  const std::size_t told = sequence->remarks().size();
  evaluation::SequenceViews views(*sequence, options.rectified);
  perception::VisualOdometry odometry(options.odometry);
  evaluation::SequenceView view;
  std::vector<datasets::TimedPose> trajectory;
  OdometryCount count;
  bool stopped = false;
  while (!(stopped = options.stopped && options.stopped()) && views.next(view)) {
    const perception::VisualPose& pose = odometry.see(view.view);
    const auto number_ns = static_cast<std::int64_t>(view.number) * 1'000'000'000;
    const datasets::TimedPose at = evaluation::raw_camera_pose(
        pose.world_from_camera, views.rectifier().left_turn(), view.stamp_ns.value_or(number_ns));
    ++count.views;
    count.begun_anew += pose.begun_anew;
    const bool begins = pose.reason == perception::NoEstimate::beginning && !pose.begun_anew;
    if (pose.known() || begins) {
      if (!trajectory.empty()) {
        count.way_m += cv::norm(at.position_m - trajectory.back().position_m);
      }
      trajectory.push_back(at);
    }
    count.known += pose.known();
    fmt::print("{}", options.json ? json_of_view(pose, view, at).dump() + "\n"
                                  : text_of_view(pose, view, at));
  }
  tell_left_out(*sequence, told);
  fmt::print("{}",
             options.json ? ordered_json{{"summary", count.json()}}.dump() + "\n" : count.text());
  if (!options.out.empty()) write_file(options.out, datasets::tum_text(trajectory));
  if (stopped) return 130;
  return count.known > 0 ? 0 : 1;
}

}  // namespace striate::app
