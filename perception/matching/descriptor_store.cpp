#include "striate/perception/matching/descriptor_store.hpp"

#include <stdexcept>

namespace striate::perception {
namespace {

constexpr std::size_t kBlocksAtOnce = 2;  // the search reads blocks in pairs (search_kernels.hpp)

std::size_t blocks_for(std::size_t count) {
  // Descriptors that room is made for at a time
  constexpr std::size_t kUnit = kBlocksAtOnce * DescriptorBlock::kSize;
  return (count + kUnit - 1) / kUnit * kBlocksAtOnce;
}

}  // namespace

void DescriptorStore::reserve(std::size_t count) {
  blocks_.reserve(blocks_for(count));
}

void DescriptorStore::append(const Descriptor& descriptor) {
  const std::size_t block = size_ / DescriptorBlock::kSize, lane = size_ % DescriptorBlock::kSize;
  if (block == blocks_.size()) blocks_.resize(blocks_.size() + kBlocksAtOnce);
  const std::array<std::uint64_t, 4> words = stored_words(descriptor);
  for (std::size_t w = 0; w < words.size(); ++w) blocks_[block].words[w][lane] = words[w];
  ++size_;
}

void DescriptorStore::append(std::span<const Descriptor> descriptors) {
  for (const Descriptor& descriptor : descriptors) append(descriptor);
}

void DescriptorStore::clear() {
  blocks_.clear();
  size_ = 0;
}

Descriptor DescriptorStore::at(std::size_t index) const {
  if (index >= size_) throw std::out_of_range("DescriptorStore: no such descriptor");
  Descriptor result;
  for (std::size_t w = 0; w < result.words.size(); ++w) {
    const std::uint64_t word =
        blocks_[index / DescriptorBlock::kSize].words[w][index % DescriptorBlock::kSize];
    result.words[w] = std::rotr(word, static_cast<int>(19 * w));
  }
  return result;
}

}  // namespace striate::perception
