#include "striate/base/crc32c.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "striate/base/crc_table.hpp"

namespace striate {
namespace {

TEST(Crc32c, IsTheSameOnEveryProcessor) {
  const std::string text = "123456789";
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  EXPECT_EQ(crc32c(bytes), 0xE3069283U);
  EXPECT_EQ(crc32c_by_tables(bytes), 0xE3069283U);
  EXPECT_EQ(crc32c(std::span(bytes).subspan(4), crc32c(std::span(bytes).first(4))), 0xE3069283U);
  std::vector<std::uint8_t> longer(5003);
  for (std::size_t k = 0; k < longer.size(); ++k) longer[k] = static_cast<std::uint8_t>(k * k / 7);
  for (const std::size_t size : {0U, 1U, 7U, 8U, 1003U, 1535U, 1536U, 1544U, 3072U, 5003U}) {
    const auto part = std::span(longer).first(size);
    EXPECT_EQ(crc32c(part, 17), crc32c_by_tables(part, 17)) << size;
  }
}

/// Printed check values of "123456789": CRC-32C and CRC-32 (ISO 3309).
TEST(CrcTable, GivesTheKnownChecksumsOfBothPolynomials) {
  const auto of_digits = [](std::uint32_t polynomial) {
    const auto table = reflected_crc_table(polynomial);
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const char digit : std::string("123456789")) {
      crc = (crc >> 8) ^ table[(crc ^ static_cast<std::uint8_t>(digit)) & 0xFF];
    }
    return ~crc;
  };
  EXPECT_EQ(of_digits(0x82F63B78U), 0xE3069283U);
  EXPECT_EQ(of_digits(0xEDB88320U), 0xCBF43926U);
}

}  // namespace
}  // namespace striate
