#pragma once

#include <functional>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <utility>

#include "striate/perception/visual_odometry/rigid_motion.hpp"
#include "striate/perception/visual_odometry/stereo_eyes.hpp"
#include "striate/platform/datasets/calibration/picture_rectifier.hpp"
#include "striate/platform/datasets/sequences/sequence.hpp"
#include "striate/platform/datasets/trajectories/trajectory.hpp"

namespace striate::evaluation {

/// One moment of a sequence, as visual odometry sees it.
struct SequenceView {
  std::size_t number = 0;
  std::string name;
  std::optional<std::int64_t> stamp_ns;
  perception::StereoView view;
};

/// A sequence's pairs, grey and rectified by its calibration.
class SequenceViews {
 public:
  /// @param rectified the pictures are rectified already, whatever the calibration is of
  /// @param tell is given the rectifier once, when the first view has told the pictures' size
  SequenceViews(datasets::Sequence& sequence, bool rectified,
                std::function<void(const datasets::PictureRectifier&)> tell = {})
      : sequence_(&sequence), rectified_(rectified), tell_(std::move(tell)) {}

  /// @return false at the end
  /// @throws UserError where there is no calibration, no second eye or no baseline, saying what to
  /// do
  [[nodiscard]] bool next(SequenceView& view);

  /// After the first view.
  [[nodiscard]] const datasets::PictureRectifier& rectifier() const { return *rectifier_; }

 private:
  datasets::Sequence* sequence_;
  bool rectified_;
  std::function<void(const datasets::PictureRectifier&)> tell_;
  std::optional<datasets::PictureRectifier> rectifier_;
};

/// The pose of the left camera as it was before pictures were rectified, in the world of the first
/// one's axes.
[[nodiscard]] datasets::TimedPose raw_camera_pose(const perception::RigidMotion& world_from_camera,
                                                  const cv::Matx33d& left_turn,
                                                  std::int64_t stamp_ns);

}  // namespace striate::evaluation
