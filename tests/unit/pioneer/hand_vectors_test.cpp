#include <gtest/gtest.h>

#include "striate/platform/pioneer/arcos/command.hpp"
#include "striate/platform/pioneer/arcos/packet_stream.hpp"
#include "striate/platform/pioneer/arcos/sip.hpp"
#include "striate/platform/pioneer/laser/lms200.hpp"
#include "striate/platform/pioneer/laser/scip.hpp"
#include "striate/platform/pioneer/turret/dynamixel.hpp"
#include "tests/reference/captures.hpp"

/// Bytes worked out by hand from the protocols' public definitions; the arithmetic stands beside.
namespace striate::pioneer {
namespace {

using reference::from_hex;

TEST(HandVectors, ArcosChecksumAddsPairsAndXorsTheOddByte) {
  // VEL 300: 0b 3b 2c 01 are the pairs 0x0b3b + 0x2c01 = 0x373c, high byte first on the wire.
  EXPECT_EQ(arcos::checksum(from_hex("0b 3b 2c 01")), 0x373c);
  EXPECT_EQ(arcos::command(arcos::Command::velocity, 300), from_hex("fa fb 06 0b 3b 2c 01 37 3c"));
  // 0x2a2b + 0x0241 = 0x2c6c; the fifth byte: 0x6c ^ 0x42 = 0x2e.
  EXPECT_EQ(arcos::checksum(from_hex("2a 2b 02 41 42")), 0x2c2e);
  // 0xffff + 0x0002 = 0x10001, of which 16 bits are kept.
  EXPECT_EQ(arcos::checksum(from_hex("ff ff 00 02")), 0x0001);
}

TEST(HandVectors, ArcosSip) {
  // 32 | x 2000 = 0x07d0 | y -100 mm: 0x8000 - 100 = 0x7f9c | heading 90 deg = 1024 = 0x0400 |
  // left 150 = 0x96, right 250 = 0xfa mm/s | battery 13.0 V = 0x82 | stall, control 0 | flags 0x1f
  // | compass 0 | one reading: disc 3, 1000 mm = 0x03e8. 23 bytes and the sum: count 0x19. 0x32d0 +
  // 0x079c + 0x7f00 + 0x0496 + 0x00fa + 0x0082 + 0 + 0 + 0x1f00 + 0x0001 + 0x03e8 = 0xe267, and the
  // odd byte: 0x67 ^ 0x03 = 0x64.
  arcos::PacketStream stream;
  stream.push(
      from_hex("fa fb 19 32 d0 07 9c 7f 00 04 96 00 fa 00 82 00 00 00 00 1f 00 00 01 "
               "03 e8 03 e2 64"));
  const auto packet = stream.next();
  ASSERT_TRUE(packet);
  const auto sip = arcos::read_sip(*packet);
  ASSERT_TRUE(sip);
  EXPECT_EQ(sip->x, 2000);
  EXPECT_EQ(sip->y, 0x7f9c);
  EXPECT_EQ(sip->heading, 1024);
  EXPECT_EQ(sip->left_mm_s, 150);
  EXPECT_EQ(sip->right_mm_s, 250);
  EXPECT_EQ(sip->battery_dv, 130);
  EXPECT_EQ(sip->flags, 0x1f);
  ASSERT_EQ(sip->sonar.size(), 1u);
  EXPECT_EQ(sip->sonar[0].disc, 3);
  EXPECT_EQ(sip->sonar[0].range, 1000);
}

TEST(HandVectors, ScipSumAndThreeCharacters) {
  // Six bits of the sum, plus 0x30. "00": 2 * 48 = 0x60, & 0x3f = 0x20, + 0x30 = 'P'.
  EXPECT_EQ(scip::sum_of("00"), 'P');
  // "99": 2 * 57 = 0x72, & 0x3f = 0x32, + 0x30 = 'b'.
  EXPECT_EQ(scip::sum_of("99"), 'b');
  // 1160 mm = 0 * 64 * 64 + 18 * 64 + 8: 0x30, 0x30 + 18 = 'B', 0x30 + 8 = '8'.
  // "0B8": 48 + 66 + 56 = 0xaa, & 0x3f = 0x2a, + 0x30 = 'Z'. "0000": 192 = 0xc0: '0'.
  // 384 is the step that looks ahead.
  const std::string text = "MD0384038401000\n99b\n00000\n0B8Z\n\n";
  scip::ReplyStream stream;
  stream.push(Bytes(text.begin(), text.end()));
  const auto reply = stream.next();
  ASSERT_TRUE(reply);
  const auto scan = scip::read_scan(*reply, scip::Parameters{});
  ASSERT_TRUE(scan);
  ASSERT_EQ(scan->rays.size(), 1u);
  EXPECT_NEAR(scan->rays[0].distance_m, 1.160, 1e-9);
  EXPECT_NEAR(scan->rays[0].bearing_rad, 0.0, 1e-9);
}

TEST(HandVectors, Lms200CrcOfAReset) {
  // Each step: twice the sum, XOR the byte and 256 times the one before.
  // 02: 0x0002; 00: 0x0004 ^ 0x0200 = 0x0204; 01: 0x0408 ^ 0x0001 = 0x0409;
  // 00: 0x0812 ^ 0x0100 = 0x0912; 10: 0x1224 ^ 0x0010 = 0x1234, low byte first on the wire.
  EXPECT_EQ(lms200::crc(from_hex("02 00 01 00 10")), 0x1234);
  EXPECT_EQ(lms200::reset(), from_hex("02 00 01 00 10 34 12"));
}

TEST(HandVectors, Lms200ScanInMillimetres) {
  // Two values, bit 14 for millimetres: 0x4002; 1000 = 0x03e8, 2500 = 0x09c4; status 0x10.
  const auto scan = lms200::read_scan({lms200::kFromLaser, from_hex("b0 02 40 e8 03 c4 09 10")});
  ASSERT_TRUE(scan);
  ASSERT_EQ(scan->ranges_m.size(), 2u);
  EXPECT_NEAR(scan->ranges_m[0], 1.0, 1e-9);
  EXPECT_NEAR(scan->ranges_m[1], 2.5, 1e-9);
}

TEST(HandVectors, DynamixelSumIsTurnedOver) {
  // 700 = 0x02bc; 0x01 + 0x05 + 0x03 + 0x1e + 0xbc + 0x02 = 0xe5, ~0xe5 & 0xff = 0x1a.
  EXPECT_EQ(dynamixel::write_word(1, dynamixel::Register::goal_position, 700),
            from_hex("ff ff 01 05 03 1e bc 02 1a"));
}

}  // namespace
}  // namespace striate::pioneer
