#include "striate/memory/long_term/view_codec.hpp"

#include <array>
#include <cstring>

namespace striate::memory {
namespace {

static_assert(sizeof(perception::ViewKeypoint) == 16 && sizeof(StoredDescriptor) == 32);

template <class T>
std::span<const std::uint8_t> as_bytes(const std::vector<T>& all) {
  return {reinterpret_cast<const std::uint8_t*>(all.data()), all.size() * sizeof(T)};
}

template <class T>
void unpack_as(std::span<const std::uint8_t> bytes, std::vector<T>& all) {
  all.resize(bytes.size() / sizeof(T));
  if (!all.empty()) std::memcpy(all.data(), bytes.data(), all.size() * sizeof(T));
}

}  // namespace

std::span<const std::uint8_t> bytes_of(const SQLite::Column& column) {
  const auto* data = static_cast<const std::uint8_t*>(column.getBlob());
  return {data, data == nullptr ? 0 : static_cast<std::size_t>(column.getBytes())};
}

std::span<const std::uint8_t> bytes_of(const std::vector<StoredDescriptor>& all) {
  return as_bytes(all);
}

std::span<const std::uint8_t> bytes_of(const std::vector<perception::ViewKeypoint>& all) {
  return as_bytes(all);
}

void unpack(std::span<const std::uint8_t> bytes, std::vector<StoredDescriptor>& all) {
  unpack_as(bytes, all);
}

void unpack(std::span<const std::uint8_t> bytes, std::vector<perception::ViewKeypoint>& all) {
  unpack_as(bytes, all);
}

std::uint32_t checksum_of_view(double width_px, double height_px,
                               std::span<const std::uint8_t> descriptors,
                               std::span<const std::uint8_t> keypoints) {
  std::array<std::uint8_t, 16> size{};
  std::memcpy(size.data(), &width_px, 8);
  std::memcpy(size.data() + 8, &height_px, 8);
  return crc32c(keypoints, crc32c(descriptors, crc32c(size)));
}

StoredDescriptor stored(const perception::Descriptor& descriptor) {
  StoredDescriptor bytes{};
  std::memcpy(bytes.data(), descriptor.words.data(), bytes.size());
  return bytes;
}

perception::Descriptor descriptor_of(const StoredDescriptor& stored) {
  perception::Descriptor descriptor;
  std::memcpy(descriptor.words.data(), stored.data(), stored.size());
  return descriptor;
}

}  // namespace striate::memory
