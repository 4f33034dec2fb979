#pragma once

#include <vector>

#include "striate/memory/long_term/records.hpp"
#include "striate/perception/matching/descriptor_store.hpp"
#include "striate/perception/matching/hamming_search.hpp"
#include "striate/perception/recognition/consensus.hpp"

namespace striate::memory {

/// How much two views have in common.
struct Agreement {
  int inliers = 0;     ///< keypoints that match and agree on one pose
  double share = 0.0;  ///< of the keypoints of the view that has fewer
};

/// Tells whether two views show the same thing, by the rule of recognition: near descriptors whose
/// places agree on a pose. Keeps its buffers.
class ViewComparer {
 public:
  explicit ViewComparer(const perception::RecognitionSettings& settings = {})
      : settings_(settings), consensus_(settings) {}

  [[nodiscard]] Agreement compare(const StoredView& a, const StoredView& b);

 private:
  perception::RecognitionSettings settings_;
  perception::DescriptorStore store_;
  perception::HammingSearch search_;
  perception::ConsensusFinder consensus_;
  std::vector<perception::Descriptor> queries_;
  std::vector<perception::PlacePair> pairs_;
};

}  // namespace striate::memory
