#include <gtest/gtest.h>

#include "striate/platform/pioneer/arcos/command.hpp"
#include "striate/platform/pioneer/arcos/config_pac.hpp"
#include "striate/platform/pioneer/arcos/other_packets.hpp"
#include "striate/platform/pioneer/arcos/packet_stream.hpp"
#include "striate/platform/pioneer/arcos/sip.hpp"
#include "tests/reference/captures.hpp"

namespace striate::pioneer::arcos {
namespace {

using reference::from_hex;

Packet packet_of(const std::string& hex) {
  PacketStream stream;
  stream.push(from_hex(hex));
  const auto packet = stream.next();
  if (!packet) throw std::runtime_error("no packet in: " + hex);
  return *packet;
}

TEST(ArcosCommand, EncodesAsTheKnownClientsDo) {
  EXPECT_EQ(command(Command::sync2), from_hex("fa fb 03 02 00 02"));
  EXPECT_EQ(command(Command::open, 1), from_hex("fa fb 06 01 3b 01 00 02 3b"));
  EXPECT_EQ(command(Command::enable, 1), from_hex("fa fb 06 04 3b 01 00 05 3b"));
  EXPECT_EQ(command(Command::velocity, 300), from_hex("fa fb 06 0b 3b 2c 01 37 3c"));
  EXPECT_EQ(command(Command::rotation_velocity, -30), from_hex("fa fb 06 15 1b 1e 00 33 1b"));
  EXPECT_EQ(command(Command::move, -200), from_hex("fa fb 06 08 1b c8 00 d0 1b"));
  EXPECT_EQ(command(Command::wheels, 10, 5), from_hex("fa fb 06 20 3b 0a 05 2a 40"));
  EXPECT_EQ(command(Command::set_acceleration, -300), from_hex("fa fb 06 05 1b 2c 01 31 1c"));
  EXPECT_EQ(command(Command::emergency_stop), from_hex("fa fb 03 37 00 37"));
}

TEST(ArcosCommand, IsReadBackLeniently) {
  EXPECT_EQ(read_argument(packet_of("fa fb 06 15 1b 1e 00 33 1b")).value, -30);
  EXPECT_FALSE(read_argument(packet_of("fa fb 04 07 3b 07 3b")).present) << "a type, no value";
  EXPECT_FALSE(read_argument({2, {}}).present);
  EXPECT_EQ(read_argument({11, {0x3b, 0xff, 0xff}}).value, -1) << "3B with a negative int16";
  EXPECT_FALSE(read_argument({11, {0x77, 1, 2}}).present);
  const Argument text = read_argument({3, {0x2b, 9, 'a', 'b'}});
  EXPECT_EQ(text.text, "ab") << "a length that promises too much";
  const Bytes polling = command(Command::polling, "\001\005");
  PacketStream stream;
  stream.push(polling);
  EXPECT_EQ(read_argument(*stream.next()).text, "\001\005");
}

TEST(ArcosSip, OfARealPioneerEndsAfterTheDigitalOutputs) {
  const auto sip = read_sip(
      packet_of("fa fb 21 32 00 00 00 00 00 00 00 00 00 00 90 fe fe 00 00 00 00 00 02 04 00 7d 07 "
                "00 7d 05 00 59 30 f0 11 b4"));
  ASSERT_TRUE(sip);
  EXPECT_EQ(sip->battery_dv, 144);
  EXPECT_EQ(sip->stall_and_bumpers, 0xfefe);
  ASSERT_EQ(sip->sonar.size(), 2u);
  EXPECT_EQ(sip->sonar[0].disc, 4);
  EXPECT_EQ(sip->sonar[1].range, 32000);
  EXPECT_EQ(sip->digital_in, 0x30);
  EXPECT_EQ(sip->digital_out, 0xf0);
  EXPECT_FALSE(sip->battery_x10_dv);
  EXPECT_FALSE(sip->rotation_ddeg_s);
}

TEST(ArcosSip, ThatAnnouncesReadingsAndSendsNoneKeepsItsTail) {
  const auto sip = read_sip(
      packet_of("fa fb 26 32 00 00 00 00 00 00 00 00 00 00 82 00 00 00 00 1f 00 00 10 00 00 00 ff "
                "ff 82 00 00 00 00 00 00 00 00 81 00 d3 13"));
  ASSERT_TRUE(sip);
  EXPECT_TRUE(sip->sonar.empty());
  EXPECT_EQ(sip->battery_x10_dv, 130);
  EXPECT_EQ(sip->temperature_c, -127);
  EXPECT_EQ(sip->charge_percent, 0);
}

TEST(ArcosSip, IsWrittenAsItIsRead) {
  Sip sip;
  sip.x = 0x7fff;
  sip.y = 12;
  sip.heading = -2048;
  sip.left_mm_s = -300;
  sip.right_mm_s = 300;
  sip.battery_dv = 121;
  sip.stall_and_bumpers = 0x0201;
  sip.flags = SipFlag::motors_on | SipFlag::stop_pressed;
  sip.sonar = {{0, 5000}, {15, 170}};
  sip.rotation_ddeg_s = -1234;
  const Packet packet = write_sip(sip);
  const auto read = read_sip(packet);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->x, 0x7fff);
  EXPECT_EQ(read->heading, -2048);
  EXPECT_EQ(read->left_mm_s, -300);
  EXPECT_EQ(read->flags, SipFlag::motors_on | SipFlag::stop_pressed);
  ASSERT_EQ(read->sonar.size(), 2u);
  EXPECT_EQ(read->sonar[1].disc, 15);
  EXPECT_EQ(read->rotation_ddeg_s, -1234);
  EXPECT_EQ(write_sip(*read), packet);
}

TEST(ArcosSip, CutOffAnywhereIsShorterOrNone) {
  Sip sip;
  sip.sonar.assign(16, {3, 1000});
  const Packet whole = write_sip(sip);
  for (std::size_t size = 0; size <= whole.payload.size(); ++size) {
    Packet cut = whole;
    cut.payload.resize(size);
    EXPECT_EQ(read_sip(cut).has_value(), size >= 19) << size;
  }
}

TEST(ArcosConfigPac, OfARealPioneerBeyond127BytesIsRead) {
  // The first 57 bytes of a real P3DX-SH's; the rest reads as nothing.
  const Bytes bytes = from_hex(
      "50 69 6f 6e 65 65 72 00 70 33 64 78 2d 73 68 00 47 4a 43 5f 33 31 35 36 00 00 68 01 e8 03 "
      "2c 01 d0 07 f4 01 46 41 50 45 53 50 5f 33 31 35 36 00 64 00 00 00 00");
  Packet packet{ConfigPac::kId, bytes};
  packet.payload.resize(0x89 - 3);
  const Bytes wire = encode(packet);
  EXPECT_EQ(wire[2], 0x89);
  PacketStream stream;
  stream.push(wire);
  const auto config = read_config_pac(*stream.next());
  ASSERT_TRUE(config);
  EXPECT_EQ(config->subtype, "p3dx-sh");
  EXPECT_EQ(config->serial, "GJC_3156");
  EXPECT_EQ(config->rotation_top_deg_s, 360);
  EXPECT_EQ(config->velocity_top_mm_s, 1000);
  EXPECT_EQ(config->rotation_acceleration_top_deg_s2, 300);
  EXPECT_EQ(config->acceleration_top_mm_s2, 2000);
  EXPECT_EQ(config->pwm_max, 500);
  EXPECT_EQ(config->sip_cycle_ms, 100);
  EXPECT_EQ(config->watchdog_ms, 0);
}

TEST(ArcosConfigPac, IsWrittenAsItIsRead) {
  ConfigPac config;
  config.type = "Pioneer";
  config.subtype = "p3dx";
  config.watchdog_ms = 2000;
  config.drift_factor = -7;
  config.firmware = "3.0";
  config.kinematics_delay_ms = 9;
  const auto read = read_config_pac(write_config_pac(config));
  ASSERT_TRUE(read);
  EXPECT_EQ(read->subtype, "p3dx");
  EXPECT_EQ(read->watchdog_ms, 2000);
  EXPECT_EQ(read->drift_factor, -7);
  EXPECT_EQ(read->firmware, "3.0");
  EXPECT_EQ(read->kinematics_delay_ms, 9);
  EXPECT_FALSE(read_config_pac({ConfigPac::kId, {'a', 0, 'b', 0, 'c'}}));
}

TEST(ArcosNames, EndTheHandshake) {
  const auto names = read_names(packet_of(
      "fa fb 18 02 41 4d 52 49 53 69 6d 00 50 69 6f 6e 65 65 72 00 70 33 64 78 00 eb bd"));
  ASSERT_TRUE(names);
  EXPECT_EQ(names->name, "AMRISim");
  EXPECT_EQ(names->kind, "Pioneer");
  EXPECT_EQ(names->subclass, "p3dx");
  EXPECT_FALSE(read_names({2, {}}));
}

TEST(ArcosSimPackets, TellTheTruthAndALaser) {
  const auto stat = read_sim_stat(write_sim_stat({-1234, 567, -90}));
  ASSERT_TRUE(stat);
  EXPECT_EQ(stat->x_mm, -1234);
  EXPECT_EQ(stat->heading_deg, -90);
  std::vector<std::uint16_t> ranges(181);
  for (std::size_t i = 0; i < ranges.size(); ++i) ranges[i] = static_cast<std::uint16_t>(100 + i);
  const std::vector<Packet> packets = write_sim_laser(ranges);
  ASSERT_EQ(packets.size(), 6u);
  const auto last = read_sim_laser(packets[5]);
  ASSERT_TRUE(last);
  EXPECT_EQ(last->total, 181);
  EXPECT_EQ(last->first, 160);
  EXPECT_EQ(last->ranges_mm.back(), 280);
  EXPECT_FALSE(read_sim_laser({SimLaser::kId, {1, 0, 0, 0, 32, 5}}));
}

TEST(ArcosSimPackets, ASweepWithALostPartIsNone) {
  const std::vector<Packet> packets = write_sim_laser(std::vector<std::uint16_t>(181, 700));
  SimLaserSweep sweep;
  for (std::size_t lost = 0; lost < packets.size(); ++lost) {
    int whole = 0;
    for (std::size_t i = 0; i < packets.size(); ++i) {
      if (i != lost) whole += sweep.take(*read_sim_laser(packets[i])) ? 1 : 0;
    }
    EXPECT_EQ(whole, 0) << lost;
    for (const Packet& packet : packets) whole += sweep.take(*read_sim_laser(packet)) ? 1 : 0;
    EXPECT_EQ(whole, 1) << lost;
  }
}

TEST(ArcosCaptures, AreUnderstoodPacketByPacket) {
  for (const auto& file : reference::arcos_captures()) {
    PacketStream stream;
    stream.push(reference::one_way(reference::read_capture(file), "R>C"));
    int sips = 0;
    while (const auto packet = stream.next()) {
      if (is_sip(*packet)) {
        const auto sip = read_sip(*packet);
        ASSERT_TRUE(sip) << file;
        ++sips;
        EXPECT_TRUE(sip->sonar.empty() || sip->sonar.size() == 16) << file;
        EXPECT_EQ(sip->battery_dv, 130) << file;
      } else if (packet->id == ConfigPac::kId) {
        const auto config = read_config_pac(*packet);
        ASSERT_TRUE(config) << file;
        EXPECT_EQ(config->serial, "SIM") << file;
        EXPECT_EQ(config->velocity_max_mm_s, 3000) << file;
        EXPECT_EQ(config->firmware, "S.0") << file;
      } else if (packet->id == SimLaser::kId) {
        const auto laser = read_sim_laser(*packet);
        ASSERT_TRUE(laser) << file;
        EXPECT_EQ(laser->total, 181) << file;
      } else if (packet->id == SimStat::kId) {
        EXPECT_TRUE(read_sim_stat(*packet)) << file;
      }
    }
    EXPECT_GT(sips, 30) << file;
  }
}

}  // namespace
}  // namespace striate::pioneer::arcos
