#pragma once

#include "striate/platform/interface/senses.hpp"
#include "striate/platform/simulator/scene.hpp"

namespace striate::simulator {

/// Makes what the cameras see. The renderer is one; tests bring a plain one.
class ImageSource {
 public:
  virtual ~ImageSource() = default;

  /// The image pair of a moment. `stamp` and `head` of the result are filled in by the body.
  virtual StereoFrame image(const SceneState& scene) = 0;

  /// How light it is at a place of the plan, for judging: 0 dark .. 1 like a lit office corridor,
  /// more in the sun.
  [[nodiscard]] virtual double light_level(Point2 place) const = 0;
};

}  // namespace striate::simulator
