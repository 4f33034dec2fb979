#include "striate/base/crc32c.hpp"

#include <array>
#include <bit>
#include <cstring>

#include "striate/base/crc_table.hpp"

namespace striate {
namespace {

static_assert(std::endian::native == std::endian::little, "the tables are read little-endian");

using Tables = std::array<std::array<std::uint32_t, 256>, 8>;

constexpr Tables make_tables() {
  Tables tables{};
  tables[0] = reflected_crc_table(0x82F63B78U);
  for (std::size_t k = 1; k < tables.size(); ++k) {
    for (std::size_t byte = 0; byte < 256; ++byte) {
      const std::uint32_t value = tables[k - 1][byte];
      tables[k][byte] = (value >> 8) ^ tables[0][value & 0xFF];
    }
  }
  return tables;
}

constexpr Tables kTables = make_tables();

#if defined(__x86_64__)

// By hand: a view of 150 descriptors of 32 bytes is three rounds of three lanes.
constexpr std::size_t kLane_bytes = 512;

/// What kLane_bytes of zeros make of each byte of a register: the step is linear, so a register's
/// four bytes can be looked up apart.
constexpr std::array<std::array<std::uint32_t, 256>, 4> make_lane_tables() {
  std::array<std::uint32_t, 32> of_bit{};
  for (std::size_t bit = 0; bit < of_bit.size(); ++bit) {
    std::uint32_t value = 1U << bit;
    for (std::size_t k = 0; k < kLane_bytes; ++k) value = (value >> 8) ^ kTables[0][value & 0xFF];
    of_bit[bit] = value;
  }
  std::array<std::array<std::uint32_t, 256>, 4> tables{};
  for (std::size_t place = 0; place < 4; ++place) {
    for (std::size_t byte = 0; byte < 256; ++byte) {
      for (std::size_t bit = 0; bit < 8; ++bit) {
        if ((byte >> bit & 1) != 0) tables[place][byte] ^= of_bit[8 * place + bit];
      }
    }
  }
  return tables;
}

std::uint32_t past_a_lane(std::uint64_t crc) {
  static constexpr auto kLanes = make_lane_tables();
  return kLanes[0][crc & 0xFF] ^ kLanes[1][crc >> 8 & 0xFF] ^ kLanes[2][crc >> 16 & 0xFF] ^
         kLanes[3][crc >> 24 & 0xFF];
}

std::uint64_t eight_bytes(const std::uint8_t* at) {
  std::uint64_t eight = 0;
  std::memcpy(&eight, at, 8);
  return eight;
}

/// The instruction takes three cycles and a new one can start in each: three lanes at once.
__attribute__((target("sse4.2"))) std::uint32_t crc32c_by_instruction(
    std::span<const std::uint8_t> bytes, std::uint32_t before) {
  std::uint64_t crc = ~before;
  const std::uint8_t* at = bytes.data();
  const std::uint8_t* const end = at + bytes.size();
  for (; end - at >= static_cast<std::ptrdiff_t>(3 * kLane_bytes); at += 3 * kLane_bytes) {
    std::uint64_t second = 0;
    std::uint64_t third = 0;
    for (std::size_t k = 0; k < kLane_bytes; k += 8) {
      crc = __builtin_ia32_crc32di(crc, eight_bytes(at + k));
      second = __builtin_ia32_crc32di(second, eight_bytes(at + kLane_bytes + k));
      third = __builtin_ia32_crc32di(third, eight_bytes(at + 2 * kLane_bytes + k));
    }
    crc = past_a_lane(past_a_lane(crc) ^ second) ^ third;
  }
  for (; end - at >= 8; at += 8) crc = __builtin_ia32_crc32di(crc, eight_bytes(at));
  auto last = static_cast<std::uint32_t>(crc);
  for (; at < end; ++at) last = __builtin_ia32_crc32qi(last, *at);
  return ~last;
}

#endif

}  // namespace

std::uint32_t crc32c(std::span<const std::uint8_t> bytes, std::uint32_t before) {
#if defined(__x86_64__)
  static const bool has_instruction = __builtin_cpu_supports("sse4.2") != 0;
  if (has_instruction) return crc32c_by_instruction(bytes, before);
#endif
  return crc32c_by_tables(bytes, before);
}

std::uint32_t crc32c_by_tables(std::span<const std::uint8_t> bytes, std::uint32_t before) {
  std::uint32_t crc = ~before;
  std::size_t at = 0;
  for (; at + 8 <= bytes.size(); at += 8) {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    std::memcpy(&low, bytes.data() + at, 4);
    std::memcpy(&high, bytes.data() + at + 4, 4);
    low ^= crc;
    crc = kTables[7][low & 0xFF] ^ kTables[6][(low >> 8) & 0xFF] ^ kTables[5][(low >> 16) & 0xFF] ^
          kTables[4][low >> 24] ^ kTables[3][high & 0xFF] ^ kTables[2][(high >> 8) & 0xFF] ^
          kTables[1][(high >> 16) & 0xFF] ^ kTables[0][high >> 24];
  }
  for (; at < bytes.size(); ++at) crc = (crc >> 8) ^ kTables[0][(crc ^ bytes[at]) & 0xFF];
  return ~crc;
}

}  // namespace striate
