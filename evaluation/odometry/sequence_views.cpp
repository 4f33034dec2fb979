#include "striate/evaluation/odometry/sequence_views.hpp"

#include <fmt/format.h>

#include <opencv2/imgproc.hpp>

#include "striate/base/user_error.hpp"

namespace striate::evaluation {
namespace {

void refuse_without_lengths(const datasets::Sequence& sequence, const cv::Mat3b& right) {
  if (right.empty()) {
    throw UserError(
        "visual odometry needs two eyes: this sequence has one\n    hint: --side-by-side where "
        "each "
        "picture holds both");
  }
  if (!sequence.calibration()) {
    throw UserError(
        "visual odometry needs the calibration of the camera: none was found\n    hint: "
        "--calibration FILE, as striate calibrate, OpenCV, ROS, Kalibr, EuRoC or KITTI write it");
  }
}

}  // namespace

bool SequenceViews::next(SequenceView& to) {
  datasets::SequenceLook look;
  if (!sequence_->next(look)) return false;
  refuse_without_lengths(*sequence_, look.right);
  if (!rectifier_) {
    rectifier_.emplace(*sequence_->calibration(), look.left.size(), rectified_);
    if (!(rectifier_->baseline_m() > 0.0)) {
      throw UserError(fmt::format(
          "{}: does not tell how far apart the eyes are\n    hint: a calibration of both eyes",
          sequence_->calibration_file()));
    }
    if (tell_) tell_(*rectifier_);
  }
  StereoFrame frame;
  rectifier_->rectify(look.left, look.right, frame);
  to.number = look.number;
  to.name = look.name;
  to.stamp_ns = look.stamp_ns;
  cv::Mat1b left, right;
  cv::cvtColor(frame.left, left, cv::COLOR_BGR2GRAY);
  cv::cvtColor(frame.right, right, cv::COLOR_BGR2GRAY);
  to.view = {left,
             right,
             {frame.focal_px, frame.centre_u_px, frame.centre_v_px, frame.baseline_m,
              rectifier_->doffs_px()}};
  return true;
}

datasets::TimedPose raw_camera_pose(const perception::RigidMotion& world_from_camera,
                                    const cv::Matx33d& left_turn, std::int64_t stamp_ns) {
  datasets::TimedPose pose;
  pose.stamp_ns = stamp_ns;
  pose.rotation = left_turn.t() * world_from_camera.rotation * left_turn;
  pose.position_m = left_turn.t() * world_from_camera.way_m;
  return pose;
}

}  // namespace striate::evaluation
