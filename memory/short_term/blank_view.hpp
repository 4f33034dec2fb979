#pragma once

#include "striate/memory/short_term/local_grid.hpp"
#include "striate/perception/percept.hpp"

namespace striate::memory {

/// Blank walls, one of the paper's causes of failure: a surface without texture gives no match, and
/// the nearer it is the more of the view it fills. A view in which image after image hardly
/// anything is known, neither floor nor thing, is taken for such a surface close by: the floor
/// before the robot that was never seen free counts as occupied until it is seen.
class BlankView {
 public:
  /// Once an image. `pose` is the robot's in the odometry frame at the moment of the image.
  void see(const perception::Percept& percept, const Pose2& pose, LocalGrid& grid);

 private:
  int blankness_ = 0;  ///< of the images in a row
};

}  // namespace striate::memory
