#pragma once

#include <opencv2/core/mat.hpp>

#include "striate/perception/percept.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::agent::pictures {

/// What the columns say of the floor, seen from above: the robot at the bottom middle looking up,
/// free stretches green, obstacles red (the stronger the surer), rings every `ring` of `reach`.
struct PlanScale {
  double reach = 6.0;  ///< from the robot to the top, in the percept's unit of length
  double ring = 2.0;
  const char* unit = "m";
  double robot = RobotDescription{}.front_m;  ///< radius of the disc that stands for it
};

[[nodiscard]] cv::Mat3b draw_plan_of_columns(const perception::Percept& percept, cv::Size size,
                                             const PlanScale& scale);

}  // namespace striate::agent::pictures
