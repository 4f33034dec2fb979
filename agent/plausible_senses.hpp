#pragma once

#include <string>

#include "striate/platform/interface/senses.hpp"

namespace striate::agent {

/// What a body feels, whatever body it is, enters the mind here. An image that cannot be is put
/// aside: `senses` keeps the one before, which grows old, so that the limiter slows and stops.
/// @return why an image was refused, in plain words; empty: none was
/// @throws std::runtime_error for anything else that cannot be: without odometry nothing can go on
[[nodiscard]] std::string refuse_implausible(Senses& senses, const StereoFrame& before);

}  // namespace striate::agent
