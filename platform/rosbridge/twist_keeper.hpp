#pragma once

#include <memory>

#include "striate/platform/remote/zero_keeper.hpp"
#include "striate/platform/rosbridge/bridge_settings.hpp"

namespace striate::rosbridge {

/// A keeper that is a rosbridge client of its own, which says zero on `cmd_vel`.
[[nodiscard]] std::unique_ptr<remote::ZeroKeeper> make_twist_keeper(const BridgeSettings& settings);

}  // namespace striate::rosbridge
