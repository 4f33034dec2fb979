#pragma once

#include <map>
#include <span>
#include <vector>

#include "striate/perception/matching/hamming_search.hpp"

namespace striate::evaluation {

/// Words, that is centres, of binary descriptors: k means in Hamming space. Each round gives a
/// descriptor to its nearest centre, and a centre the bits of the majority of its descriptors
/// (k-majority). It begins at descriptors that lie evenly in the list; no random numbers.
[[nodiscard]] std::vector<perception::Descriptor> learn_words(
    std::span<const perception::Descriptor> descriptors, std::size_t words);

/// How often an image has each word, weighted by how rare the word is; the sum of weights is 1.
using WordBag = std::map<std::uint32_t, double>;

/// Bags of words of the images of one run.
class WordBags {
 public:
  /// Learns the words and how rare each is on all images.
  WordBags(std::span<const std::vector<perception::Descriptor>> images, std::size_t words);
  [[nodiscard]] const WordBag& of(std::size_t image) const { return bags_[image]; }

 private:
  std::vector<WordBag> bags_;
};

/// 0..1: 1 for the same bag (Nister and Stewenius 2006, the L1 norm).
[[nodiscard]] double bag_likeness(const WordBag& a, const WordBag& b);

}  // namespace striate::evaluation
