#pragma once

#include <memory>

#include "striate/platform/interface/motor_command.hpp"
#include "striate/platform/interface/senses.hpp"

namespace striate::python {

/// What a robot felt in one cycle. Its images are nobody else's, so that arrays may look at them.
using SharedSenses = std::shared_ptr<const Senses>;

/// A copy with images of its own: bodies use theirs again.
[[nodiscard]] SharedSenses copied(const Senses& senses);

/// A copy without images.
[[nodiscard]] SharedSenses without_images(const Senses& senses);

}  // namespace striate::python
