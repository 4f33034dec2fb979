#pragma once

#include <opencv2/core/mat.hpp>

#include "perception/percept.hpp"
#include "platform/interface/robot.hpp"
#include "platform/interface/senses.hpp"

namespace striate::pictures {

struct OverviewStyle {
  int tile_width_px = 480;
  bool metric = true;       ///< false: the disparity's legend is in px
  const char* unit = "m";   ///< of the percept's lengths, for labels
  double plan_reach = 6.0;  ///< of the floor plan, in that unit
};

/// All of one percept on one sheet: left, right, disparity / obstacles, saliency, floor plan.
/// Works for one-eyed frames and for percepts with parts missing. Throws nothing for any content.
[[nodiscard]] cv::Mat3b draw_overview(const StereoFrame& frame, const Percept& percept,
                                      const RobotDescription& robot = {},
                                      const OverviewStyle& style = {});

}  // namespace striate::pictures
