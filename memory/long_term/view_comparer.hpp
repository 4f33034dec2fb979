#pragma once

#include <vector>

#include "memory/long_term/records.hpp"
#include "perception/matching/descriptor_store.hpp"
#include "perception/matching/hamming_search.hpp"
#include "perception/recognition/consensus.hpp"

namespace striate {

/// How much two views have in common.
struct Agreement {
  int inliers = 0;     ///< keypoints that match and agree on one pose
  double share = 0.0;  ///< of the keypoints of the view that has fewer
};

/// Tells whether two views show the same thing, by the rule of recognition: near descriptors whose
/// places agree on a pose. Keeps its buffers.
class ViewComparer {
 public:
  explicit ViewComparer(const RecognitionSettings& settings = {})
      : settings_(settings), consensus_(settings) {}

  [[nodiscard]] Agreement compare(const StoredView& a, const StoredView& b);

 private:
  RecognitionSettings settings_;
  DescriptorStore store_;
  HammingSearch search_;
  ConsensusFinder consensus_;
  std::vector<Descriptor> queries_;
  std::vector<PlacePair> pairs_;
};

}  // namespace striate
