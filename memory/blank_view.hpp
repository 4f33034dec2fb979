#pragma once

#include "memory/local_grid.hpp"
#include "perception/percept.hpp"

namespace striate {

/// Blank walls, one of the paper's causes of failure: a surface without texture gives no match, and
/// the nearer it is the more of the view it fills. A view in which picture after picture hardly
/// anything is known, neither floor nor thing, is taken for such a surface close by: the floor
/// before the robot that was never seen free counts as occupied until it is seen.
class BlankView {
 public:
  /// Once a picture. `pose` is the robot's in the odometry frame at the moment of the picture.
  void see(const Percept& percept, const Pose2& pose, LocalGrid& grid);

 private:
  int blankness_ = 0;  ///< of the pictures in a row
};

}  // namespace striate
