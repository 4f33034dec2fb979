#pragma once

#include "striate/platform/interface/robot.hpp"
#include "striate/viewer/channels/reports.hpp"

namespace striate::viewer {

/// What was found in an image, as `kSeenSchema` says. Numbers are rounded to what can be seen.
[[nodiscard]] Json seen_json(const CycleFacts& facts, const RobotDescription& robot);

}  // namespace striate::viewer
