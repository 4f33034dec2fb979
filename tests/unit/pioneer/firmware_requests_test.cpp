#include <gtest/gtest.h>

#include <cmath>

#include "striate/platform/pioneer/firmware/arcos_firmware.hpp"

/// What the firmware's model answers to a client's requests.
namespace striate::pioneer {
namespace {

using arcos::Command;
using arcos::command;
using arcos::Packet;

/// An open session, in steps of 10 ms.
struct OpenController {
  OpenController() {
    for (const Command id : {Command::sync0, Command::sync1, Command::sync2}) say(command(id));
    say(command(Command::open, 1));
    (void)run(0.05);
  }
  void say(const Bytes& bytes) { firmware.receive(bytes, now); }
  std::vector<Packet> heard() {
    arcos::PacketStream stream;
    stream.push(firmware.take_output());
    std::vector<Packet> packets;
    while (auto packet = stream.next()) packets.push_back(std::move(*packet));
    return packets;
  }
  std::vector<Packet> run(double seconds) {
    for (double t = 0.0; t < seconds - 1e-9; t += 0.01) {
      now += std::chrono::milliseconds(10);
      firmware.step(now, std::chrono::milliseconds(10), felt);
      say(command(Command::pulse));
    }
    return heard();
  }
  std::vector<Packet> of(std::uint8_t id, const std::vector<Packet>& packets) {
    std::vector<Packet> found;
    for (const Packet& packet : packets) {
      if (packet.id == id) found.push_back(packet);
    }
    return found;
  }
  std::pair<double, double> wheels_mm() {
    (void)heard();
    say(command(Command::encoder, 1));
    const auto told = of(arcos::Encoders::kId, heard());
    EXPECT_EQ(told.size(), 1u);
    ByteReader reader(told.at(0).payload);
    const double left = reader.i32() / 128.0;
    return {left, reader.i32() / 128.0};
  }
  /// The body goes so, in small steps.
  void go(double way_m, double turn_rad) {
    for (int i = 0; i < 100; ++i) {
      Pose2& pose = felt.odometry.pose;
      pose.heading_rad = wrap_angle(pose.heading_rad + turn_rad / 200);
      pose.x_m += way_m / 100 * std::cos(pose.heading_rad);
      pose.y_m += way_m / 100 * std::sin(pose.heading_rad);
      pose.heading_rad = wrap_angle(pose.heading_rad + turn_rad / 200);
      (void)run(0.01);
    }
  }
  ArcosFirmware firmware{FirmwareSettings{}};
  FirmwareSenses felt;
  TimePoint now{std::chrono::seconds(1)};
};

TEST(ArcosFirmware, CountsWhatEachWheelHasRolled) {
  OpenController robot;
  robot.go(0.5, 0.0);
  EXPECT_NEAR(robot.wheels_mm().first, 500.0, 0.5);
  EXPECT_NEAR(robot.wheels_mm().second, 500.0, 0.5);
  robot.go(0.0, radians(90.0));
  robot.go(0.4, 0.0);
  const double quarter_mm = 178.6 * kPi / 2.0;
  EXPECT_NEAR(robot.wheels_mm().first, 900.0 - quarter_mm, 1.0) << "also across x";
  EXPECT_NEAR(robot.wheels_mm().second, 900.0 + quarter_mm, 1.0);
  robot.say(command(Command::set_origin));
  robot.go(-0.9, radians(300.0));
  robot.go(0.0, radians(-390.0));
  EXPECT_NEAR(robot.wheels_mm().first, 0.0, 1.5) << "backwards, through 180 degrees, SETO or not";
  EXPECT_NEAR(robot.wheels_mm().second, 0.0, 1.5);
}

TEST(ArcosFirmware, AnswersOnceOrWithEachSipWhatIsAskedFor) {
  const std::pair<Command, std::uint8_t> requests[] = {
      {Command::io_request, arcos::IoPac::kId},
      {Command::battery_info, arcos::BatteryPac::kId},
      {Command::encoder, arcos::Encoders::kId},
      {Command::joystick_info, arcos::Joystick::kId}};
  for (const auto& [request, id] : requests) {
    OpenController robot;
    robot.say(command(request, 1));
    EXPECT_EQ(robot.of(id, robot.run(1.0)).size(), 1u) << static_cast<int>(id);
    robot.say(command(request, 2));
    EXPECT_EQ(robot.of(id, robot.run(1.0)).size(), 10u) << static_cast<int>(id);
    robot.say(command(request, 0));
    EXPECT_TRUE(robot.of(id, robot.run(1.0)).empty()) << static_cast<int>(id);
  }
}

TEST(ArcosFirmware, TellsPortsBumpersAndCharge) {
  OpenController robot;
  robot.felt.bumper_front = true;
  robot.felt.battery_v = 12.7;
  (void)robot.run(0.02);
  robot.say(command(Command::digital_out, 0x05, 0x0f));
  robot.say(command(Command::digital_out, 0xff, 0x80));
  robot.say(command(Command::io_request, 1));
  robot.say(command(Command::battery_info, 1));
  const auto packets = robot.run(0.2);
  const auto io = robot.of(arcos::IoPac::kId, packets);
  ASSERT_EQ(io.size(), 1u);
  ByteReader reader(io[0].payload);
  ASSERT_EQ(reader.u8(), 4);
  EXPECT_EQ(reader.u8(), 0);
  EXPECT_NE(reader.u8(), 0) << "front bumpers";
  EXPECT_EQ(reader.u8(), 0);
  (void)reader.u8();
  ASSERT_EQ(reader.u8(), 1);
  EXPECT_EQ(reader.u8(), 0x85);
  const std::size_t ports = reader.u8();
  EXPECT_EQ(2 * ports, reader.left()) << "analog ports, two bytes each";
  const auto battery = robot.of(arcos::BatteryPac::kId, packets);
  ASSERT_EQ(battery.size(), 1u);
  EXPECT_EQ(battery[0].payload, (Bytes{1, 5, 0, 0, 0, 100, 100}));
  const auto sips = robot.of(0x32, packets);
  ASSERT_FALSE(sips.empty());
  EXPECT_EQ(arcos::read_sip(sips.back())->digital_out, 0x85);
}

TEST(ArcosFirmware, ItsGyroAddsUpToTheTurn) {
  OpenController robot;
  robot.felt.true_turn_rad_s = radians(7.3);  // no whole number of counts
  robot.say(command(Command::gyro, 1));
  const auto told = robot.of(arcos::GyroPac::kId, robot.run(3.0));
  EXPECT_EQ(told.size(), 30u);
  double turned_deg = 0.0;
  for (const Packet& packet : told) {
    ByteReader reader(packet.payload);
    const int count = reader.u8();
    EXPECT_EQ(count, 4) << "one each 25 ms";
    for (int i = 0; i < count; ++i) {
      turned_deg -= (reader.i16() - arcos::GyroPac::kStands) * arcos::GyroPac::kCount_deg_s * 0.025;
      (void)reader.u8();
    }
  }
  EXPECT_NEAR(turned_deg, 21.9, 0.8) << "the last cycle may be on its way";
  robot.say(command(Command::gyro, 0));
  EXPECT_TRUE(robot.of(arcos::GyroPac::kId, robot.run(0.5)).empty());
}

TEST(ArcosFirmware, LooksWhereTheInBandLaserIsTold) {
  OpenController robot;
  EXPECT_EQ(robot.firmware.laser_bearings_rad().size(), 181u);
  const auto field = [&](int start, int end, int step) {
    robot.say(command(Command::laser_start, start));
    robot.say(command(Command::laser_end, end));
    robot.say(command(Command::laser_increment, step));
    return robot.firmware.laser_bearings_rad();
  };
  EXPECT_EQ(field(-90, 90, 50).size(), 361u);
  const auto narrow = field(-50, 50, 100);
  ASSERT_EQ(narrow.size(), 101u);
  EXPECT_NEAR(narrow.front(), radians(-50.0), 1e-9);
  EXPECT_NEAR(narrow.back(), radians(50.0), 1e-9);
  const auto from_left = field(135, -135, 200);
  ASSERT_EQ(from_left.size(), 136u);
  EXPECT_NEAR(from_left.front(), radians(135.0), 1e-9);
  EXPECT_EQ(field(-200, 900, 100).size(), 361u) << "no further than behind";
  EXPECT_EQ(field(-180, 180, 1).size(), 1441u) << "no finer than a quarter of a degree";
  robot.say(command(Command::sim_laser_start, 0));
  robot.say(command(Command::sim_laser_increment, 100));
  EXPECT_EQ(robot.firmware.laser_bearings_rad().size(), 181u) << "as the simulators' own ids";
}

TEST(ArcosFirmware, SendsTheLaserInTheFormThatIsAskedFor) {
  OpenController robot;
  robot.say(command(Command::laser_mode, 1));
  robot.firmware.laser(std::vector<std::uint16_t>(40, 1234));
  const auto old = robot.of(arcos::OldSimLaser::kId, robot.heard());
  ASSERT_EQ(old.size(), 2u);
  ByteReader reader(ByteView(old[1].payload).subspan(6));
  EXPECT_EQ(reader.u16(), 40);
  EXPECT_EQ(reader.u16(), 32);
  EXPECT_EQ(reader.u8(), 8);
  EXPECT_EQ(reader.u16(), 1234);
  EXPECT_EQ(reader.left(), 14u);
  robot.say(command(Command::sim_laser_mode, 2));
  robot.firmware.laser(std::vector<std::uint16_t>(40, 1234));
  EXPECT_EQ(robot.of(arcos::SimLaser::kId, robot.heard()).size(), 2u);
  robot.say(command(Command::laser_mode, 0));
  EXPECT_FALSE(robot.firmware.laser_wanted());
}

TEST(ArcosFirmware, IsPutWhereASimulatorsClientSays) {
  OpenController robot;
  EXPECT_FALSE(robot.firmware.take_new_place());
  Bytes payload{0x3b};
  for (const std::int32_t value : {5000, -300, -450}) ByteWriter(payload).i32(value);
  robot.say(arcos::encode({224, payload}));
  const auto place = robot.firmware.take_new_place();
  ASSERT_TRUE(place);
  EXPECT_NEAR(place->x_m, 5.0, 1e-9);
  EXPECT_NEAR(place->y_m, -0.3, 1e-9);
  EXPECT_NEAR(place->heading_rad, radians(-90.0), 1e-9);
  EXPECT_FALSE(robot.firmware.take_new_place()) << "once";
  robot.say(arcos::encode({224, Bytes(payload.begin() + 1, payload.end())}));
  EXPECT_NEAR(robot.firmware.take_new_place()->x_m, 5.0, 1e-9) << "also without the type byte";
  robot.say(arcos::encode({224, {0x3b, 1, 0}}));
  EXPECT_FALSE(robot.firmware.take_new_place()) << "too short";
  robot.felt.odometry.pose = {1.0, 2.0, 0.5};
  (void)robot.run(0.02);
  robot.say(arcos::encode({225, {}}));
  EXPECT_TRUE(robot.firmware.take_new_place()) << "where it began";
  const auto sips = robot.of(0x32, robot.run(0.2));
  ASSERT_FALSE(sips.empty());
  EXPECT_EQ(arcos::read_sip(sips.back())->x, 0) << "and its odometry is 0";
}

TEST(ArcosFirmware, BeginsAnewWhenItIsReset) {
  OpenController robot;
  robot.say(command(Command::reset));
  EXPECT_FALSE(robot.firmware.connected());
}

TEST(RobotModel, IsTheKindWhateverLaserItsNameTells) {
  for (const char* name : {"p3dx-sh-lms1xx", "p3dx-sh-lms200", "p3dx-sh-lms500"}) {
    ASSERT_NE(find_model(name), nullptr) << name;
    EXPECT_EQ(find_model(name)->subclass, "p3dx-sh");
  }
  ASSERT_NE(find_model("p3dx-lms2xx"), nullptr);
  EXPECT_DOUBLE_EQ(find_model("p3dx-lms2xx")->distance_mm, 0.485);
  ASSERT_NE(find_model("p3at-sh-lms500"), nullptr);
  EXPECT_EQ(find_model("p3at-sh-lms500")->subclass, "p3at-sh") << "other wheels";
  EXPECT_EQ(find_model("-lms200"), nullptr);
  EXPECT_EQ(find_model("p3dx-lms" + std::string(300, 'x')), nullptr) << "no packet holds it";
  EXPECT_EQ(find_model("p3dx-sh-lms\x1b[2"), nullptr);
}

/// A ramp that runs beyond what the motors do begins its way down from a speed that is not there.
TEST(ArcosFirmware, NoSpeedIsSetThatTheMotorsDoNotReach) {
  OpenController robot;
  robot.say(command(Command::enable, 1));
  for (const Command limit : {Command::set_velocity, Command::set_rotation,
                              Command::set_acceleration, Command::set_rotation_acceleration}) {
    robot.say(command(limit, 30000));
  }
  robot.say(command(Command::velocity, 30000));
  robot.say(command(Command::rotation_velocity, 30000));
  (void)robot.run(5.0);
  EXPECT_DOUBLE_EQ(robot.firmware.forward_m_s(), 1.0);
  EXPECT_NEAR(robot.firmware.turn_rad_s(), radians(360.0), 1e-9);
  robot.say(command(Command::stop));
  (void)robot.run(1.0 / 0.3 + 0.1);
  EXPECT_EQ(robot.firmware.forward_m_s(), 0.0) << "at 300 mm/s2";
}

TEST(ArcosFirmware, ABatteryThatIsPlayedIsTheNextClientsNoMore) {
  OpenController robot;
  const auto told_dv = [&] {
    int dv = -1;
    for (const Packet& packet : robot.run(0.25)) {
      if (const auto sip = arcos::read_sip(packet)) dv = sip->battery_dv;
    }
    return dv;
  };
  const int full_dv = told_dv();
  EXPECT_GT(full_dv, 110);
  robot.say(command(Command::battery_test, 80));
  EXPECT_EQ(told_dv(), 80);
  robot.say(command(Command::battery_test, 0));
  EXPECT_EQ(told_dv(), full_dv);
  robot.say(command(Command::battery_test, 80));
  robot.say(command(Command::close));
  for (const Command id : {Command::sync0, Command::sync1, Command::sync2}) robot.say(command(id));
  robot.say(command(Command::open, 1));
  EXPECT_EQ(told_dv(), full_dv);
}

}  // namespace
}  // namespace striate::pioneer
