#pragma once

#include "striate/platform/rosbridge/bridge_address.hpp"
#include "striate/platform/rosbridge/bridge_settings.hpp"

namespace striate::rosbridge {

/// What the settings' own ranges cannot say. @return where the server is
/// @throws UserError with what is wrong, and where
BridgeAddress check_settings(const BridgeSettings& settings);

}  // namespace striate::rosbridge
