#pragma once

#include <deque>
#include <opencv2/core/mat.hpp>
#include <string>

#include "striate/agent/cognitive_cycle.hpp"

namespace striate::agent::pictures {

/// One cycle of a run: camera with what stands in the way, disparity, saliency, the map with the
/// trail (see draw_map), and a caption below.
[[nodiscard]] cv::Mat3b draw_cycle_sheet(const CognitiveCycle& cycle, const RobotDescription& robot,
                                         const std::deque<Point2>& trajectory,
                                         const std::string& caption);

/// "  12.3 s    4.2 m along   0.40 m/s   traverse_corridor: follows the middle"
[[nodiscard]] std::string cycle_caption(const CognitiveCycle& cycle, double along_m,
                                        std::string_view action);

}  // namespace striate::agent::pictures
