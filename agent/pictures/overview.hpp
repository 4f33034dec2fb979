#pragma once

#include <opencv2/core/mat.hpp>

#include "striate/perception/percept.hpp"
#include "striate/platform/interface/robot.hpp"
#include "striate/platform/interface/senses.hpp"

namespace striate::agent::pictures {

struct OverviewStyle {
  int tile_width_px = 480;
  bool metric = true;       ///< false: the disparity's legend is in px
  const char* unit = "m";   ///< of the percept's lengths, for labels
  double plan_reach = 6.0;  ///< of the floor plan, in that unit
};

/// All of one percept on one sheet: left, right, disparity / obstacles, saliency, floor plan.
/// Works for one-eyed frames and for percepts with parts missing. Throws nothing for any content.
[[nodiscard]] cv::Mat3b draw_overview(const StereoFrame& frame, const perception::Percept& percept,
                                      const RobotDescription& robot = {},
                                      const OverviewStyle& style = {});

}  // namespace striate::agent::pictures
