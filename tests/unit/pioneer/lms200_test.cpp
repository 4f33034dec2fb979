#include "striate/platform/pioneer/laser/lms200.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/reference/captures.hpp"

namespace striate::pioneer::lms200 {
namespace {

using reference::from_hex;

std::vector<Telegram> decode(const Bytes& bytes, std::size_t chunk,
                             std::uint8_t sender = kFromLaser) {
  TelegramStream stream(sender);
  std::vector<Telegram> telegrams;
  const auto drain = [&] {
    while (auto telegram = stream.next()) telegrams.push_back(std::move(*telegram));
  };
  for (std::size_t at = 0; at < bytes.size(); at += chunk) {
    stream.push(ByteView(bytes).subspan(at, std::min(chunk, bytes.size() - at)));
    drain();
  }
  while (stream.waiting()) {
    stream.give_up_waiting();
    drain();
  }
  return telegrams;
}

bool at_most_one_lost(const std::vector<Telegram>& all, const std::vector<Telegram>& fewer) {
  if (fewer.size() > all.size() || fewer.size() + 1 < all.size()) return false;
  const auto [a, b] = std::mismatch(all.begin(), all.end(), fewer.begin(), fewer.end());
  if (a == all.end()) return b == fewer.end();
  return std::equal(a + 1, all.end(), b, fewer.end());
}

TEST(Lms200, CommandsAreThoseOfTheKnownClients) {
  EXPECT_EQ(reset(), from_hex("02 00 01 00 10 34 12"));
  EXPECT_EQ(continuous(true), from_hex("02 00 02 00 20 24 34 08"));
  EXPECT_EQ(set_variant(180, 0), from_hex("02 00 05 00 3b b4 00 00 00 5f 2d"));
}

TEST(Lms200, AScanComesBackAsItWasWritten) {
  std::vector<double> ranges_m(181, 2.5);
  ranges_m[90] = INFINITY;
  const auto telegrams = decode(encode(write_scan(ranges_m)), 5);
  ASSERT_EQ(telegrams.size(), 1u);
  EXPECT_EQ(telegrams[0].address, kFromLaser);
  const auto scan = read_scan(telegrams[0]);
  ASSERT_TRUE(scan);
  ASSERT_EQ(scan->ranges_m.size(), 181u);
  EXPECT_DOUBLE_EQ(scan->ranges_m[0], 2.5);
  EXPECT_TRUE(std::isinf(scan->ranges_m[90]));
  EXPECT_FALSE(read_scan({kFromLaser, {0xb0, 0xb5, 0x40, 1, 2}})) << "shorter than it says";
  EXPECT_FALSE(read_scan({kFromLaser, {0x90}}));
}

TEST(Lms200, OneFlippedBitCostsAtMostOneTelegram) {
  Bytes bytes;
  for (int i = 0; i < 6; ++i) {
    append(bytes, Bytes{0x06});
    append(bytes, encode(write_scan(std::vector<double>(20 + 7 * i, 1.0 + 0.1 * i))));
  }
  const auto all = decode(bytes, bytes.size());
  ASSERT_EQ(all.size(), 6u);
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    Bytes flipped = bytes;
    flipped[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    ASSERT_TRUE(at_most_one_lost(all, decode(flipped, 64))) << bit;
  }
}

TEST(Lms200Capture, DecodesInAnyChunkingAndWithAFlippedBit) {
  for (const auto& file : reference::lms_captures()) {
    SCOPED_TRACE(file);
    const bool ours = file.filename() == "lms200.hex";
    const auto chunks = reference::read_capture(file);
    EXPECT_EQ(decode(reference::one_way(chunks, "H>L"), 1, kToLaser).size(), 5u);
    Bytes bytes = reference::one_way(chunks, "L>H");
    const auto all = decode(bytes, bytes.size());
    int scans = 0;
    for (const Telegram& telegram : all) {
      const auto scan = read_scan(telegram);
      if (!scan) continue;
      ASSERT_EQ(scan->ranges_m.size(), 181u);
      EXPECT_NEAR(scan->ranges_m[0], 1.0, 0.001);
      if (ours) {
        EXPECT_NEAR(scan->ranges_m[180], 1.36, 0.0005) << "2 mm more each degree";
      }
      ++scans;
    }
    EXPECT_GT(scans, 30);
    for (const std::size_t chunk : {1, 2, 3, 7, 64, 1000}) EXPECT_EQ(decode(bytes, chunk), all);
    bytes.resize(1300);
    const auto sample = decode(bytes, bytes.size());
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
      Bytes flipped = bytes;
      flipped[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
      ASSERT_TRUE(at_most_one_lost(sample, decode(flipped, 64))) << bit;
    }
  }
}

}  // namespace
}  // namespace striate::pioneer::lms200
