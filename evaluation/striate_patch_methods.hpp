#pragma once

#include <vector>

#include "striate/evaluation/patch_methods.hpp"

namespace striate::evaluation {

/// Striate's own descriptor with the frame's angle as given and with its own, and the paper's.
[[nodiscard]] std::vector<PatchMethod> striate_patch_methods();

}  // namespace striate::evaluation
