#pragma once

#include "platform/interface/steady_clock.hpp"

namespace striate::pioneer {

using striate::SteadyClock;

}  // namespace striate::pioneer
