#include "striate/app/perceive_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

#include "striate/agent/pictures/overview.hpp"
#include "striate/app/near_blobs.hpp"
#include "striate/base/files.hpp"
#include "striate/base/index_within.hpp"
#include "striate/base/say.hpp"
#include "striate/base/user_error.hpp"
#include "striate/perception/perception.hpp"
#include "striate/perception/stereo/pair_check.hpp"
#include "striate/platform/interface/align_eyes.hpp"
#include "striate/platform/interface/plausible.hpp"

namespace striate::app {
namespace {

int candidates_for(const PerceiveOptions& o) {
  if (o.candidates > 0) return o.candidates;
  return std::clamp(150 * o.width_px / 160, 1, kMostCandidates);
}

/// Without a focal length nothing is said of the camera, and it is taken for one that can be.
std::string why_unusable(const PerceiveOptions& o, const StereoFrame& given) {
  StereoFrame frame = given;
  RobotDescription robot;
  if (frame.focal_px <= 0.0) {
    frame.focal_px = frame.left.cols;
    frame.baseline_m = 1.0;
  }
  robot.camera_height_m = o.camera_height_m.value_or(robot.camera_height_m);
  const std::string why = why_implausible(frame);
  return why.empty() ? why_implausible(robot) : why;
}

/// How far the right principal point lies right of the left one, in the files' pixels.
double doffs_of(const PerceiveOptions& o, const StereoFrame& frame) {
  if (o.right_centre_u_px) return *o.right_centre_u_px - frame.centre_u_px;
  return o.doffs_px.value_or(0.0);
}

/// The right end of the left image shows what the right eye, whose principal point lies farther
/// right, has no columns for. The robust mode distrusts what it finds there; the paper's takes the
/// likest place in the row, however near that puts it.
void forget_what_one_eye_saw(const PerceiveOptions& o, const StereoFrame& frame,
                             JudgedFrame& judged) {
  cv::Mat1f& map = judged.percept.disparity.disparity_px;
  const int columns = static_cast<int>(std::ceil(judged.report.doffs_px));
  if (o.mode != "paper" || map.empty() || columns <= 0) return;
  map.colRange(std::max(0, map.cols - columns), map.cols).setTo(perception::kNoMatch);
  if (!o.camera_height_m) return;  // the others' obstacles are looked for behind this
  perception::ObstacleView view = perception::find_obstacles_as_in_paper(
      judged.percept.disparity, frame.head, judged.robot, perception::ObstacleSettings{});
  judged.percept.columns = std::move(view.columns);
  judged.percept.obstacles = std::move(view.obstacles);
}

double reach_of(const JudgedFrame& judged) {
  if (judged.report.floor_known) return 6.0;
  double farthest = 1.0;
  for (const perception::Column& c : judged.percept.columns) {
    farthest = std::max(farthest, c.free_to_m);
  }
  return 1.2 * farthest;
}

}  // namespace

void check_perceive(const PerceiveOptions& o) {
  if (o.mode != "paper" && o.mode != "robust") {
    throw UserError(fmt::format("--mode {}: choose paper or robust", o.mode));
  }
  if (o.width_px < kLeastWidth_px || o.width_px > kMostWidth_px) {
    throw UserError(fmt::format("--width-px {}: the working width must be {} to {} px", o.width_px,
                                kLeastWidth_px, kMostWidth_px));
  }
  if (o.candidates < 0 || o.candidates > kMostCandidates) {
    throw UserError(
        fmt::format("--candidates {}: {} disparities can be searched at most; 0: 150 "
                    "at width 160",
                    o.candidates, kMostCandidates));
  }
  if (!(std::abs(o.tilt_deg) <= kMostTilt_deg)) {  // nor what is no number
    throw UserError(fmt::format("--tilt-deg {}: a camera is tilted by {} degrees at most",
                                o.tilt_deg, kMostTilt_deg));
  }
  if (!(o.near_px >= 0.0) || !std::isfinite(o.near_px)) {
    throw UserError(fmt::format("--near-px {}: must be a threshold in px, or 0", o.near_px));
  }
  if ((o.focal_px > 0.0) != (o.baseline_m > 0.0)) {
    throw UserError("distances need both --focal-px and --baseline-m: give both or neither");
  }
  if (o.focal_px < 0.0 || o.baseline_m < 0.0) {
    throw UserError("--focal-px and --baseline-m must be positive");
  }
  if (o.camera_height_m && *o.camera_height_m <= 0.0) {
    throw UserError("--camera-height-m must be positive, and needs --focal-px and --baseline-m");
  }
}

void place_camera(const PerceiveOptions& o, const std::string& name, StereoFrame& frame) {
  if (o.camera_height_m && o.focal_px <= 0.0) {
    throw UserError(
        "--camera-height-m needs a camera that measures: --calibration FILE of both eyes, or "
        "--focal-px and --baseline-m");
  }
  frame.focal_px = o.focal_px;
  frame.baseline_m = o.baseline_m;
  frame.centre_u_px = o.centre_u_px.value_or(0.5 * (frame.left.cols - 1));
  frame.centre_v_px = o.centre_v_px.value_or(0.5 * (frame.left.rows - 1));
  frame.head.tilt_rad = radians(o.tilt_deg);
  if (const std::string why = why_unusable(o, frame); !why.empty()) {
    throw UserError(
        fmt::format("{}: {}\n    check --focal-px, --baseline-m, --centre-u-px, "
                    "--centre-v-px, --camera-height-m and --tilt-deg",
                    name, why));
  }
  if (!(std::abs(doffs_of(o, frame)) < frame.left.cols)) {  // also of what is no number
    throw UserError(
        fmt::format("the principal points lie {:.6g} px apart, in images {} px wide\n"
                    "    check --doffs-px, or --right-centre-u-px",
                    doffs_of(o, frame), frame.left.cols));
  }
  align_eyes(frame, {frame.focal_px, frame.centre_u_px + doffs_of(o, frame), frame.centre_v_px});
}

JudgedFrame judge_frame(const PerceiveOptions& o, const StereoFrame& frame) {
  constexpr double kTrustedPromise =
      0.66;  // about what a score of 0.3, the driving robot's, has kept
  perception::PerceptionSettings settings;
  settings.keypoints_every = 1;
  settings.stereo = perception::StereoSettings{};
  settings.obstacles.trusted = kTrustedPromise;
  settings.stereo.mode =
      o.mode == "paper" ? perception::StereoMode::paper : perception::StereoMode::robust;
  settings.saliency.mode =
      o.mode == "paper" ? perception::SaliencyMode::paper : perception::SaliencyMode::robust;
  settings.stereo.width = o.width_px;
  settings.stereo.candidates = candidates_for(o);
  JudgedFrame judged;
  if (o.camera_height_m) judged.robot.camera_height_m = *o.camera_height_m;
  judged.percept = perception::Perception(settings, judged.robot).see(frame);
  judged.report.unit = "m";
  judged.report.doffs_px =
      doffs_of(o, frame) * judged.percept.disparity.disparity_px.cols / frame.left.cols;
  judged.report.floor_known = o.camera_height_m.has_value();
  forget_what_one_eye_saw(o, frame, judged);
  if (frame.right.empty()) {
    judged.report.method = "none: one image only";
  } else if (o.camera_height_m) {
    judged.report.method = o.mode == "paper" ? "near blobs: threshold on disparity (the paper's)"
                                             : "floor line and column scan";
  } else {
    judged.percept.corridor = {};
    find_near_blobs(o, frame, judged);
  }
  return judged;
}

/// Stereo makes something of any two pictures: exchanged, identical, not rectified.
void warn_of_the_pair(const StereoFrame& frame, ObstacleReport& report, bool aloud) {
  if (frame.right.empty()) return;
  cv::Mat1b left;
  cv::Mat1b right;
  cv::cvtColor(frame.left, left, cv::COLOR_BGR2GRAY);
  cv::cvtColor(frame.right, right, cv::COLOR_BGR2GRAY);
  const perception::PairCheck check = perception::check_pair(left, right);
  const std::string text = perception::fault_text(check, frame.left.cols);
  if (text.empty()) return;
  report.warnings.push_back(text);
  if (!aloud) return;
  const perception::PairFault fault = perception::fault_of(check);
  const bool by_options =
      fault == perception::PairFault::exchanged || fault == perception::PairFault::behind;
  say(stderr, fmt::format("warning: {}\n    hint: {}{}\n", text, perception::fault_hint(fault),
                          by_options ? " (--doffs-px or --right-centre-u-px)" : ""));
}

void write_judged(const PerceiveOptions& options, const StereoFrame& frame,
                  const JudgedFrame& judged, const std::string& mark) {
  const auto file = [&](const char* name, const char* suffix) {
    return options.out / (name + mark + suffix);
  };
  const perception::Percept& percept = judged.percept;
  if (!percept.disparity.disparity_px.empty()) {
    write_pfm(file("disparity", ".pfm"), percept.disparity.disparity_px - judged.report.doffs_px);
    write_pfm(file("confidence", ".pfm"), percept.disparity.confidence);
  }
  write_file(file("obstacles", ".json"), obstacles_json(percept, options, judged.report));
  write_file(file("keypoints", ".json"), keypoints_json(percept, frame.left.size()));
  agent::pictures::OverviewStyle style;
  style.unit = judged.report.unit == "m" ? "m" : "bl";
  style.plan_reach = reach_of(judged);
  style.metric = judged.report.unit == "m";
  write_picture(file("saliency", ".png"), saliency_picture(frame, percept));
  write_picture(file("overview", ".png"),
                agent::pictures::draw_overview(frame, percept, judged.robot, style));
}

}  // namespace striate::app
