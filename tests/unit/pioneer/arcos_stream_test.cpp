#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "striate/platform/pioneer/arcos/command.hpp"
#include "striate/platform/pioneer/arcos/packet_stream.hpp"
#include "tests/reference/captures.hpp"

namespace striate::pioneer::arcos {
namespace {

using reference::from_hex;

void drain(PacketStream& stream, std::vector<Packet>& packets) {
  while (auto packet = stream.next()) packets.push_back(std::move(*packet));
}

/// All packets of the bytes handed over in chunks; what waits at the end is given up.
std::vector<Packet> decode(const Bytes& bytes, std::size_t chunk, PacketStream stream = {}) {
  std::vector<Packet> packets;
  for (std::size_t at = 0; at < bytes.size(); at += chunk) {
    stream.push(ByteView(bytes).subspan(at, std::min(chunk, bytes.size() - at)));
    drain(stream, packets);
  }
  while (stream.waiting()) {
    stream.give_up_waiting();
    drain(stream, packets);
  }
  return packets;
}

/// `fewer` is `all` with at most one packet left out.
bool at_most_one_lost(const std::vector<Packet>& all, const std::vector<Packet>& fewer) {
  if (fewer.size() > all.size() || fewer.size() + 1 < all.size()) return false;
  const auto [a, b] = std::mismatch(all.begin(), all.end(), fewer.begin(), fewer.end());
  if (a == all.end()) return b == fewer.end();
  return std::equal(a + 1, all.end(), b, fewer.end());
}

TEST(ArcosChecksum, AgreesWithThePrintedExamples) {
  EXPECT_EQ(checksum(from_hex("00")), 0x0000);
  EXPECT_EQ(checksum(from_hex("01")), 0x0001);
  EXPECT_EQ(checksum(from_hex("01 3b 01 00")), 0x023b);
  EXPECT_EQ(checksum(from_hex("04 3b 01 00")), 0x053b);
}

TEST(ArcosPacket, MayBeAsLongAsTheCountByteAllows) {
  Packet longest{0x20, Bytes(kMostPayload, 0xfa)};
  const Bytes bytes = encode(longest);
  EXPECT_EQ(bytes[2], 0xff);
  EXPECT_EQ(decode(bytes, 1), std::vector<Packet>{longest});
  longest.payload.push_back(0);
  EXPECT_THROW((void)encode(longest), std::length_error);
}

TEST(ArcosPacketStream, FindsPacketsBehindJunk) {
  Bytes bytes = from_hex("57 4d 53 32 0d fa fa fb 02 fa");
  const Bytes pulse = command(Command::pulse);
  bytes.insert(bytes.end(), pulse.begin(), pulse.end());
  PacketStream stream;
  stream.push(bytes);
  const auto packet = stream.next();
  ASSERT_TRUE(packet);
  EXPECT_EQ(packet->id, 0);
  EXPECT_EQ(stream.counters().bad_length, 1u);
  EXPECT_EQ(stream.counters().junk_bytes, 10u);
  EXPECT_FALSE(stream.next());
}

TEST(ArcosPacketStream, CountsABadChecksumAndReadsOn) {
  Bytes bytes = command(Command::velocity, 300);
  bytes[5] ^= 0x10;
  const Bytes good = command(Command::rotation_velocity, -30);
  bytes.insert(bytes.end(), good.begin(), good.end());
  PacketStream stream;
  stream.push(bytes);
  const auto packet = stream.next();
  ASSERT_TRUE(packet);
  EXPECT_EQ(packet->id, 21);
  EXPECT_EQ(stream.counters().bad_checksum, 1u);
  EXPECT_EQ(stream.counters().packets, 1u);
}

TEST(ArcosPacketStream, FindsWhatAWrongCountHasSwallowed) {
  Bytes bytes = command(Command::pulse);
  bytes[2] = 0xf0;
  for (int i = 0; i < 5; ++i) {
    const Bytes next = command(Command::velocity, 100 + i);
    bytes.insert(bytes.end(), next.begin(), next.end());
  }
  PacketStream stream;
  stream.push(bytes);
  EXPECT_FALSE(stream.next()) << "the count promises more";
  ASSERT_TRUE(stream.waiting());
  stream.give_up_waiting();
  std::vector<Packet> packets;
  drain(stream, packets);
  EXPECT_EQ(packets.size(), 5u);
  EXPECT_EQ(stream.counters().incomplete, 1u);
}

/// Packets of all sizes, with FA FB inside the data.
Bytes sample() {
  Bytes bytes;
  std::mt19937 random(7);
  for (int i = 0; i < 40; ++i) {
    Packet packet{static_cast<std::uint8_t>(i % 3 == 0 ? 0x32 : random()), {}};
    const std::size_t size = i % 5 == 4 ? 200 : random() % 90;
    for (std::size_t k = 0; k < size; ++k) {
      packet.payload.push_back(static_cast<std::uint8_t>(random()));
    }
    if (i % 4 == 1 && size > 12) {
      packet.payload[5] = 0xfa;
      packet.payload[6] = 0xfb;
      packet.payload[7] = static_cast<std::uint8_t>(random());
    }
    const Bytes encoded = encode(packet);
    bytes.insert(bytes.end(), encoded.begin(), encoded.end());
  }
  return bytes;
}

TEST(ArcosPacketStream, AnySplitGivesTheSamePackets) {
  const Bytes bytes = sample();
  const std::vector<Packet> all = decode(bytes, bytes.size());
  ASSERT_EQ(all.size(), 40u);
  for (std::size_t chunk = 1; chunk < 300; ++chunk) EXPECT_EQ(decode(bytes, chunk), all) << chunk;
}

TEST(ArcosPacketStream, OneFlippedBitCostsAtMostOnePacket) {
  const Bytes bytes = sample();
  const std::vector<Packet> all = decode(bytes, bytes.size());
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    Bytes flipped = bytes;
    flipped[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
    ASSERT_TRUE(at_most_one_lost(all, decode(flipped, 64))) << "bit " << bit;
  }
}

TEST(ArcosCaptures, DecodeInAnyChunkingWithoutABadPacket) {
  for (const auto& file : reference::arcos_captures()) {
    for (const char* way : {"C>R", "R>C"}) {
      const Bytes bytes = reference::one_way(reference::read_capture(file), way);
      ASSERT_FALSE(bytes.empty()) << file;
      PacketStream stream;
      stream.push(bytes);
      std::vector<Packet> all;
      drain(stream, all);
      EXPECT_GT(all.size(), 10u) << file;
      EXPECT_EQ(stream.counters().bad_checksum + stream.counters().bad_length, 0u) << file;
      EXPECT_FALSE(stream.waiting()) << file;
      for (const std::size_t chunk : {1, 2, 3, 5, 7, 11, 64, 1000}) {
        EXPECT_EQ(decode(bytes, chunk), all) << file << " " << chunk;
      }
      Bytes again;
      for (const Packet& packet : all) {
        const Bytes encoded = encode(packet);
        again.insert(again.end(), encoded.begin(), encoded.end());
      }
      EXPECT_EQ(again.size() + stream.counters().junk_bytes, bytes.size()) << file;
    }
  }
}

TEST(ArcosCaptures, OneFlippedBitCostsAtMostOnePacket) {
  constexpr std::size_t kSample = 2500;
  for (const auto& file : reference::arcos_captures()) {
    for (const char* way : {"C>R", "R>C"}) {
      Bytes bytes = reference::one_way(reference::read_capture(file), way);
      bytes.resize(std::min(bytes.size(), kSample));
      const std::vector<Packet> all = decode(bytes, bytes.size());
      for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
        Bytes flipped = bytes;
        flipped[bit / 8] ^= static_cast<std::uint8_t>(1U << (bit % 8));
        ASSERT_TRUE(at_most_one_lost(all, decode(flipped, 64))) << file << way << " bit " << bit;
      }
    }
  }
}

}  // namespace
}  // namespace striate::pioneer::arcos
