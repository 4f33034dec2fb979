#pragma once

#include <deque>
#include <opencv2/core/mat.hpp>

#include "striate/memory/short_term/short_term_memory.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::agent::pictures {

/// The short-term memory from above: robot in the middle looking up, free floor green, what stands
/// dark red, unknown grey; the camera's view as a wedge, the remembered corridor as lines, the
/// driven way as a trail (odometry frame, oldest first).
[[nodiscard]] cv::Mat3b draw_map(const memory::ShortTermMemory& memory,
                                 const RobotDescription& robot,
                                 const std::deque<Point2>& trajectory, int side_px);

}  // namespace striate::agent::pictures
