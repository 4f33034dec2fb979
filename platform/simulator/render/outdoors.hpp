#pragma once

#include <vector>

#include "striate/platform/simulator/render/vec.hpp"

namespace striate::simulator::render {

/// What is seen through a window: sky, trees and a lawn, brightness about 1. A map by direction,
/// painted once.
class Outdoors {
 public:
  Outdoors();
  [[nodiscard]] V4 operator()(Vec3 direction) const;

 private:
  static constexpr int kWidth = 512;                    ///< azimuth, all around
  static constexpr int kHeight = 128;                   ///< by rise over distance, -1 .. 1
  static constexpr float kHalfHeight = kHeight * 0.5F;  ///< rows above and below the horizon
  std::vector<V4> map_;
};

}  // namespace striate::simulator::render
