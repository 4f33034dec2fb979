#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "striate/base/geometry.hpp"
#include "striate/perception/motion/motion_settings.hpp"
#include "striate/perception/obstacles/view_geometry.hpp"
#include "striate/perception/percept.hpp"
#include "striate/platform/interface/robot.hpp"
#include "striate/platform/interface/senses.hpp"

namespace striate::perception {

/// One image as MotionFinder wants it.
struct MotionView {
  TimePoint stamp;
  HeadPose head;
  Pose2 base;                               ///< of the axle at `stamp`, by odometry
  cv::Mat1b grey;                           ///< left, working size
  const DisparityMap* disparity = nullptr;  ///< same size; with focal length and baseline
};

/// Finds what moves apart from the robot's own motion (ours). A pixel that stands on the floor now
/// is carried back by odometry and head pose into an image of some tenths of a second ago. There
/// it must be found again at its disparity; place_verdict.hpp says what it means if not. So turning
/// and driving, and what comes out from behind something that stays, move nothing.
///
/// Keeps copies of the last images in buffers of its own; only the search for a moving thing's
/// velocity allocates.
class MotionFinder {
 public:
  MotionFinder(const MotionSettings& settings, const RobotDescription& robot)
      : settings_(settings), robot_(robot) {}

  /// Fills `moving` of the columns (one per column of the map) and lists moving things. Nothing
  /// moves in the first images, after a pause longer than twice the gap, or after a change of
  /// size. Stamps must not go back.
  void find(const MotionView& now, std::vector<Column>& columns, std::vector<MovingThing>& moving);

 private:
  struct Kept {
    TimePoint stamp;
    HeadPose head;
    Pose2 base;
    cv::Mat1b grey;
    DisparityMap disparity;
    bool used = false;
  };
  void keep(const MotionView& now);
  [[nodiscard]] const Kept* image_before(TimePoint now) const;
  struct Comparison;  ///< of now with one kept image
  void judge_columns(const Comparison& pair, std::vector<Column>& columns);
  void list_things(const Comparison& pair, std::vector<Column>& columns,
                   std::vector<MovingThing>& moving) const;
  [[nodiscard]] bool is_sure(const MovingThing& thing) const;
  [[nodiscard]] MovingThing describe(const Comparison& pair, const std::vector<Column>& columns,
                                     int from, int to) const;

  MotionSettings settings_;
  RobotDescription robot_;
  std::array<Kept, 16> kept_;
  std::size_t next_ = 0;
  std::vector<int> came_, moved_, stayed_;  ///< judged pixels per column
};

}  // namespace striate::perception
