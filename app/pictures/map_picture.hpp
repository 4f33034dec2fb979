#pragma once

#include <deque>
#include <opencv2/core/mat.hpp>

#include "memory/short_term_memory.hpp"
#include "platform/interface/robot.hpp"

namespace striate::pictures {

/// The short-term memory from above: robot in the middle looking up, free floor green, what stands
/// dark red, unknown grey; the camera's view as a wedge, the remembered corridor as lines, the
/// driven way as a trail (odometry frame, oldest first).
[[nodiscard]] cv::Mat3b draw_map(const ShortTermMemory& memory, const RobotDescription& robot,
                                 const std::deque<Point2>& trail, int side_px);

}  // namespace striate::pictures
