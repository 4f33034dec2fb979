#pragma once

#include <string>
#include <vector>

#include "striate/agent/teaching/live_teaching.hpp"

namespace striate::agent {

/// What a recorded run is to teach.
struct RecordedTeaching {
  std::string recording;
  std::string robot;            ///< other settings than those of the recording; empty: its own
  std::vector<double> times_s;  ///< when to look, ascending; none: where `teach` looked then
};

/// Runs a recording again and takes views of what stood out ahead of the robot. Keeps nothing.
/// @throws UserError where the recording cannot be read, or ends before one of the times
[[nodiscard]] LiveViews take_views(const RecordedTeaching& recorded);

}  // namespace striate::agent
