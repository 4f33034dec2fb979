#include "striate/base/crc32.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "striate/base/crc_table.hpp"

namespace striate {
namespace {

/// The printed check value, and the plain loop, one byte after the other.
TEST(Crc32, IsThatOfIso3309AndGoesOnFromWhatCameBefore) {
  const std::string text = "123456789";
  EXPECT_EQ(crc32(std::vector<std::uint8_t>(text.begin(), text.end())), 0xCBF43926U);
  std::vector<std::uint8_t> bytes(1003);
  for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = static_cast<std::uint8_t>(k * k / 7);
  const auto table = reflected_crc_table(0xEDB88320U);
  for (const std::size_t size : {0U, 1U, 7U, 8U, 9U, 1003U}) {
    std::uint32_t plain = ~0U;
    for (std::size_t k = 0; k < size; ++k) plain = plain >> 8 ^ table[(plain ^ bytes[k]) & 0xFF];
    const auto part = std::span(bytes).first(size);
    EXPECT_EQ(crc32(part), ~plain) << size;
    EXPECT_EQ(crc32(part.subspan(size / 3), crc32(part.first(size / 3))), ~plain) << size;
  }
}

}  // namespace
}  // namespace striate
