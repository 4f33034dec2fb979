#pragma once

#include "striate/base/steady_clock.hpp"

namespace striate::pioneer {

using striate::SteadyClock;

}  // namespace striate::pioneer
