#pragma once

#include <cstdint>
#include <vector>

#include "striate/evaluation/patch_set.hpp"
#include "striate/perception/descriptor/striate_descriptor.hpp"

namespace striate::evaluation {

struct LearnedBits {
  std::vector<perception::StriateBit> bits;
  double false_positives = 0.0;  ///< at 95 % recall on the training pairs, 0..1
};

/// Chooses bits one after the other, each the best on pairs that those before it judge badly
/// (boosting with equal votes, as in BEBLID): of all comparisons of two pooled responses those
/// with the largest weighted correlation within true pairs, less within false ones, are tried at
/// five thresholds.
[[nodiscard]] LearnedBits learn_bits(const std::vector<perception::PooledResponses>& patches,
                                     const std::vector<PatchPair>& pairs, std::uint64_t seed);

}  // namespace striate::evaluation
