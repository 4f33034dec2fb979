#pragma once

#include <vector>

#include "app/evaluation/patch_methods.hpp"

namespace striate {

/// Striate's own descriptor with the frame's angle as given and with its own, and the paper's.
[[nodiscard]] std::vector<PatchMethod> striate_patch_methods();

}  // namespace striate
