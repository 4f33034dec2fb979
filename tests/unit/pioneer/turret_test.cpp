#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "striate/base/geometry.hpp"
#include "striate/platform/pioneer/turret/arbotix.hpp"
#include "striate/platform/pioneer/turret/dynamixel.hpp"
#include "tests/reference/captures.hpp"

namespace striate::pioneer {
namespace {

using reference::from_hex;

std::vector<dynamixel::Packet> decode(const Bytes& bytes, std::size_t chunk) {
  dynamixel::PacketStream stream;
  std::vector<dynamixel::Packet> packets;
  const auto drain = [&] {
    while (auto packet = stream.next()) packets.push_back(std::move(*packet));
  };
  for (std::size_t at = 0; at < bytes.size(); at += chunk) {
    stream.push(ByteView(bytes).subspan(at, std::min(chunk, bytes.size() - at)));
    drain();
  }
  while (stream.waiting()) {
    stream.give_up_waiting();
    drain();
  }
  return packets;
}

TEST(Dynamixel, InstructionsAreThoseOfTheKnownClients) {
  EXPECT_EQ(dynamixel::ping(1), from_hex("ff ff 01 02 01 fb"));
  EXPECT_EQ(dynamixel::read(1, dynamixel::Register::position, 2),
            from_hex("ff ff 01 04 02 24 02 d2"));
  EXPECT_EQ(dynamixel::write_word(1, dynamixel::Register::moving_speed, 200),
            from_hex("ff ff 01 05 03 20 c8 00 0e"));
  EXPECT_EQ(dynamixel::write_word(1, dynamixel::Register::goal_position, 700),
            from_hex("ff ff 01 05 03 1e bc 02 1a"));
}

TEST(Dynamixel, MovesSeveralServosInOnePacket) {
  const double speed_rad_s = 100 * 0.111 * 2 * M_PI / 60;
  const Bytes bytes = dynamixel::move({{1, 0.0, speed_rad_s}, {2, radians(-32.84), speed_rad_s}});
  EXPECT_EQ(bytes, from_hex("ff ff fe 0e 83 1e 04 01 00 02 64 00 02 90 01 64 00 f0"));
}

TEST(Dynamixel, AnglesAndSpeedsStayWithinTheServo) {
  EXPECT_EQ(dynamixel::ticks_of(0.0), 512);
  EXPECT_EQ(dynamixel::ticks_of(9.0), 1023);
  EXPECT_EQ(dynamixel::ticks_of(-9.0), 0);
  EXPECT_EQ(dynamixel::ticks_of(std::nan("")), 512);
  EXPECT_NEAR(dynamixel::angle_of(dynamixel::ticks_of(0.7)), 0.7, radians(0.15));
  EXPECT_EQ(dynamixel::speed_ticks_of(0.0), 1) << "0 would be the fastest";
  EXPECT_EQ(dynamixel::speed_ticks_of(-1.0), 1);
  EXPECT_EQ(dynamixel::speed_ticks_of(100.0), 1023);
}

TEST(Dynamixel, RepliesTellTheirErrors) {
  const auto packets = decode(from_hex("ff ff 02 02 02 f9 ff ff 01 04 00 2e 02 ca"), 1);
  ASSERT_EQ(packets.size(), 2u);
  EXPECT_EQ(packets[0].code, dynamixel::Error::angle_limit);
  EXPECT_EQ(packets[1].parameters, from_hex("2e 02"));
}

TEST(DynamixelCapture, DecodesInAnyChunkingAndWithAFlippedBit) {
  for (const auto& file : reference::servo_captures()) {
    SCOPED_TRACE(file);
    const auto chunks = reference::read_capture(file);
    for (const char* way : {"H>S", "S>H"}) {
      const Bytes bytes = reference::one_way(chunks, way);
      const auto all = decode(bytes, bytes.size());
      EXPECT_EQ(all.size(), std::string(way) == "H>S" ? 40u : 37u);
      for (std::size_t chunk = 1; chunk < 20; ++chunk) EXPECT_EQ(decode(bytes, chunk), all);
      Bytes again;
      for (const auto& packet : all) append(again, dynamixel::encode(packet));
      EXPECT_EQ(again, bytes);
      for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        Bytes flipped = bytes;
        flipped[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
        const auto fewer = decode(flipped, 64);
        EXPECT_GE(fewer.size() + 1, all.size()) << way << bit;
      }
    }
  }
}

TEST(Arbotix, CommandsAreEightBytesInEitherOrder) {
  const arbotix::HeadCommand command{700, 400, 0, 0};
  const Bytes bytes = arbotix::encode(command);
  EXPECT_EQ(bytes, from_hex("ff 02 bc 01 90 00 00 b0"));
  const Bytes other = arbotix::encode(command, arbotix::Order::tilt_first);
  EXPECT_EQ(other, from_hex("ff 01 90 02 bc 00 00 b0"));
  for (const auto order : {arbotix::Order::pan_first, arbotix::Order::tilt_first}) {
    arbotix::CommandStream stream(order);
    for (const std::uint8_t byte : arbotix::encode(command, order)) stream.push(ByteView(&byte, 1));
    EXPECT_EQ(stream.next(), command);
  }
}

TEST(Arbotix, FindsCommandsBehindJunkAndWrongSums) {
  Bytes bytes = from_hex("ff ff 02 02 02 f9");
  append(bytes, arbotix::encode({100, 900, 0, 0}));
  Bytes wrong = arbotix::encode({1, 2, 0, 0});
  wrong[4] ^= 1;
  append(bytes, wrong);
  append(bytes, arbotix::encode({512, 255, 0, 0}));
  arbotix::CommandStream stream;
  stream.push(bytes);
  EXPECT_EQ(stream.next(), (arbotix::HeadCommand{100, 900, 0, 0}));
  EXPECT_EQ(stream.next(), (arbotix::HeadCommand{512, 255, 0, 0}));
  EXPECT_FALSE(stream.next());
  EXPECT_GE(stream.bad_sums(), 1u);
}

}  // namespace
}  // namespace striate::pioneer
