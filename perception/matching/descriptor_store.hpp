#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "striate/perception/percept.hpp"

namespace striate::perception {

/// Eight descriptors, word by word: what one load of a vector needs lies together.
struct alignas(64) DescriptorBlock {
  /// Descriptors: 8 words of 64 bits fill the widest vector, and a line of the cache
  static constexpr std::size_t kSize = 8;
  std::array<std::array<std::uint64_t, kSize>, 4> words{};
};

/// The words as they are stored: turned against each other, so that bits that say similar things
/// (the same orientation at neighbouring points) do not meet at the same position of two words. The
/// search's quick bounds rest on it; distances are the same.
[[nodiscard]] inline std::array<std::uint64_t, 4> stored_words(const Descriptor& descriptor) {
  std::array<std::uint64_t, 4> words{};
  for (std::size_t w = 0; w < words.size(); ++w) {
    words[w] = std::rotl(descriptor.words[w], static_cast<int>(19 * w));
  }
  return words;
}

/// Descriptors in the order in which they were added, laid out for searching. Blocks come in twos,
/// so that the search has no remainder to treat; those behind the last descriptor are zero.
class DescriptorStore {
 public:
  /// Room for so many without allocating. Beyond it, appending doubles the room.
  void reserve(std::size_t count);
  void append(const Descriptor& descriptor);
  void append(std::span<const Descriptor> descriptors);
  /// Forgets the descriptors and keeps the room.
  void clear();

  [[nodiscard]] std::size_t size() const { return size_; }
  /// @param index below size(), else std::out_of_range.
  [[nodiscard]] Descriptor at(std::size_t index) const;
  /// An even number of blocks.
  [[nodiscard]] std::span<const DescriptorBlock> blocks() const { return blocks_; }

 private:
  std::vector<DescriptorBlock> blocks_;
  std::size_t size_ = 0;
};

}  // namespace striate::perception
