#pragma once

#include <cstdint>

#include "striate/evaluation/frame_pairs.hpp"

namespace striate::evaluation {

/// Which patch pairs are cut.
struct PatchChoice {
  int pairs = 20000;  ///< true ones, and as many false ones; fewer where the data has fewer
  std::uint64_t seed = 1;
  FrameTolerance tolerance;
};

}  // namespace striate::evaluation
