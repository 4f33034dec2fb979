#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "striate/perception/recognition/pose.hpp"

namespace striate::perception {

/// Which keypoints of an image speak for which of several recognitions, so that each speaks for one
/// thing only: of two boxes of one brand, the label speaks for the one that agrees in more than the
/// label. Keeps its buffers.
class Claims {
 public:
  void clear() { in_use_ = 0; }
  /// What speaks for the recognition of that number; numbers are 0, 1, 2 ... A second time it
  /// replaces the first.
  void put(std::size_t number, std::span<const PlacePair> agreeing);
  /// No recognition has taken anything.
  void begin_taking() { taken_.clear(); }
  /// What speaks for it and none has taken yet; valid until the next call.
  [[nodiscard]] std::span<const PlacePair> left(std::size_t number);
  void take(std::size_t number);

 private:
  [[nodiscard]] bool is_taken(const KeypointFrame& place) const;

  std::vector<std::vector<PlacePair>> of_;
  std::size_t in_use_ = 0;
  std::vector<KeypointFrame> taken_;  ///< places in the image
  std::vector<PlacePair> left_;
};

}  // namespace striate::perception
