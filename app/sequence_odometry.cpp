#include "striate/app/sequence_odometry.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "striate/app/own_camera.hpp"
#include "striate/app/perceive_sequence.hpp"
#include "striate/base/counted.hpp"
#include "striate/base/files.hpp"
#include "striate/base/geometry.hpp"
#include "striate/evaluation/odometry/compare_odometry.hpp"
#include "striate/evaluation/odometry/sequence_views.hpp"
#include "striate/perception/visual_odometry/visual_odometry.hpp"
#include "striate/platform/datasets/sequences/picture_list.hpp"

namespace striate::app {
namespace {

using evaluation::MethodRun;
using nlohmann::ordered_json;

ordered_json json_of_view(const perception::VisualPose& pose, const evaluation::SequenceView& view,
                          const MethodRun& run) {
  ordered_json json = {{"number", view.number}, {"name", view.name}};
  json["stamp_ns"] = view.stamp_ns ? ordered_json(*view.stamp_ns) : ordered_json(nullptr);
  json["reason"] = perception::word_of(pose.reason);
  json["begun_anew"] = pose.begun_anew;
  json["keyframe"] = pose.keyframe;
  json["points"] = pose.points;
  json["matches"] = pose.matches;
  json["agreeing"] = pose.agreeing;
  if (!pose.placed()) return json;
  const datasets::TimedPose& at = run.estimate.poses.back();
  const cv::Vec4d q = datasets::quaternion_of(at.rotation);
  json["position_m"] = {at.position_m[0], at.position_m[1], at.position_m[2]};
  json["quaternion_xyzw"] = {q[0], q[1], q[2], q[3]};
  if (!pose.known()) return json;  // nothing was measured
  json["noise_px"] = pose.noise_px;
  json["from_keyframe_sigma_m"] = pose.sigma_m();
  json["from_keyframe_sigma_deg"] = degrees(pose.sigma_rad());
  return json;
}

std::string text_of_view(const perception::VisualPose& pose, const evaluation::SequenceView& view,
                         const MethodRun& run) {
  const std::string anew =
      pose.begun_anew ? "; goes on from the last place, the way is unknown" : "";
  if (!pose.known()) {
    return fmt::format("{:6} {}: {}{}\n", view.number, view.name, text_of(pose.reason), anew);
  }
  const datasets::TimedPose& at = run.estimate.poses.back();
  return fmt::format("{:6} {}: {:.3f} {:.3f} {:.3f} m, +-{:.4f} m +-{:.3f} deg, {} points{}\n",
                     view.number, view.name, at.position_m[0], at.position_m[1], at.position_m[2],
                     pose.sigma_m(), degrees(pose.sigma_rad()), pose.agreeing,
                     pose.keyframe ? ", keyframe" : "");
}

/// What is counted over all views.
std::string text_of_all(const MethodRun& run) {
  return fmt::format("{}, {} with an estimate, {:.2f} m of way, begun anew {}\n",
                     counted(run.views, "view"), run.known, evaluation::estimated_way_m(run),
                     counted(run.begun_anew, "time"));
}

ordered_json json_of_all(const MethodRun& run) {
  return {{"views", run.views},
          {"known", run.known},
          {"way_m", evaluation::estimated_way_m(run)},
          {"begun_anew", run.begun_anew}};
}

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
  evaluation::SequenceViews views(*sequence, options.rectified,
                                  [&](const datasets::PictureRectifier& rectifier) {
                                    tell_camera(*sequence->calibration(), rectifier);
                                  });
  perception::VisualOdometry odometry(options.odometry);
  evaluation::SequenceView view;
  MethodRun run;
  bool stopped = false;
  while (!(stopped = options.stopped && options.stopped()) && views.next(view)) {
    const perception::VisualPose& pose = odometry.see(view.view);
    take_pose(pose, view.number, view.stamp_ns, views.rectifier().left_turn(), run);
    fmt::print("{}", options.json ? json_of_view(pose, view, run).dump() + "\n"
                                  : text_of_view(pose, view, run));
  }
  tell_left_out(*sequence, told);
  fmt::print("{}", options.json ? ordered_json{{"summary", json_of_all(run)}}.dump() + "\n"
                                : text_of_all(run));
  if (!options.out.empty()) write_file(options.out, datasets::tum_text(run.estimate.poses));
  if (stopped) return 130;
  return run.known > 0 ? 0 : 1;
}

}  // namespace striate::app
