#include "striate/platform/served/served_pioneer.hpp"

#include <gtest/gtest.h>

#include <cmath>

/// The served robot in virtual time, fed with a client's bytes.
namespace striate::served {
namespace {

using pioneer::arcos::Command;
using pioneer::arcos::command;
using pioneer::arcos::Packet;

simulator::World open_hall() {
  simulator::World world;
  world.length_m = 30.0;
  world.goal_beyond_m = 29.0;
  return world;
}

class ClientOfHall {
 public:
  explicit ClientOfHall(const ServedDevices& devices = {}) : robot(open_hall(), 1, {}, devices) {
    for (const Command id : {Command::sync0, Command::sync1, Command::sync2}) say(command(id));
    say(command(Command::open, 1));
    say(command(Command::enable, 1));
  }
  void say(const Bytes& bytes) { robot.firmware().receive(bytes, robot.now()); }
  void run(double seconds) {
    for (double t = 0.0; t < seconds - 1e-9; t += 0.01) {
      robot.step();
      say(command(Command::pulse));
      stream.push(robot.firmware().take_output());
      while (auto packet = stream.next()) packets.push_back(std::move(*packet));
    }
  }
  /// The last whole sweep of the in-band laser.
  std::vector<std::uint16_t> sweep(int start_deg, int end_deg, int increment_cdeg) {
    say(command(Command::laser_start, start_deg));
    say(command(Command::laser_end, end_deg));
    say(command(Command::laser_increment, increment_cdeg));
    say(command(Command::laser_mode, 2));
    packets.clear();
    run(0.3);
    pioneer::arcos::SimLaserSweep whole;
    std::vector<std::uint16_t> last;
    for (const Packet& packet : packets) {
      const auto part = pioneer::arcos::read_sim_laser(packet);
      if (part && whole.take(*part)) last = whole.ranges_mm();
    }
    return last;
  }
  void put_at(std::int32_t x_mm, std::int32_t y_mm, std::int32_t heading_deg) {
    Bytes payload{0x3b};
    for (const std::int32_t value : {x_mm, y_mm, heading_deg}) ByteWriter(payload).i32(value);
    say(pioneer::arcos::encode({static_cast<std::uint8_t>(Command::sim_set_pose), payload}));
    run(0.02);
  }
  std::pair<double, double> wheels_mm() {
    packets.clear();
    say(command(Command::encoder, 1));
    run(0.02);
    for (const Packet& packet : packets) {
      if (packet.id != pioneer::arcos::Encoders::kId) continue;
      ByteReader reader(packet.payload);
      const double left = reader.i32() / 128.0;
      return {left, reader.i32() / 128.0};
    }
    ADD_FAILURE() << "no answer";
    return {};
  }
  std::vector<double> urg_scan() {
    for (const std::string text : {"BM\n", "GD0044072501\n"}) {
      robot.laser().receive(Bytes(text.begin(), text.end()));
    }
    run(0.05);
    pioneer::scip::ReplyStream replies;
    replies.push(robot.laser().take_output());
    std::vector<double> ranges_m;
    while (const auto reply = replies.next()) {
      const auto scan = pioneer::scip::read_scan(*reply, {});
      if (!scan) continue;
      for (const auto& ray : scan->rays) ranges_m.push_back(ray.distance_m);
    }
    return ranges_m;
  }

  ServedPioneer robot;
  pioneer::arcos::PacketStream stream;
  std::vector<Packet> packets;
};

TEST(ServedRequests, TheInBandLaserLooksWhereItWasTold) {
  ClientOfHall client;
  client.put_at(10000, 200, 0);
  const double right_m = open_hall().width_m / 2.0 + 0.2;
  const double left_m = open_hall().width_m / 2.0 - 0.2;
  const auto fine = client.sweep(-90, 90, 50);
  ASSERT_EQ(fine.size(), 361u);
  EXPECT_NEAR(fine[0] / 1000.0, right_m, 0.06);
  EXPECT_NEAR(fine[60] / 1000.0, right_m / std::cos(radians(30.0)), 0.06) << "30 degrees further";
  EXPECT_NEAR(fine[360] / 1000.0, left_m, 0.06);
  const auto narrow = client.sweep(-50, 50, 100);
  ASSERT_EQ(narrow.size(), 101u);
  EXPECT_NEAR(narrow[0] / 1000.0, right_m / std::sin(radians(50.0)), 0.06);
  const auto behind = client.sweep(90, 135, 100);
  ASSERT_EQ(behind.size(), 46u);
  EXPECT_NEAR(behind[45] / 1000.0, left_m / std::sin(radians(135.0)), 0.06) << "behind its left";
}

TEST(ServedRequests, TheHokuyoMeasuresItsWholeField) {
  ClientOfHall client;
  client.put_at(10000, 200, 0);
  const auto ranges_m = client.urg_scan();
  ASSERT_EQ(ranges_m.size(), 682u);
  const double right_m = open_hall().width_m / 2.0 + 0.2;
  const double outermost_rad = 340.0 * 2.0 * kPi / 1024.0;  // step 44 of the front's 384: 119.5 deg
  EXPECT_NEAR(ranges_m.front(), right_m / std::sin(outermost_rad), 0.08);
  EXPECT_NEAR(ranges_m[84], right_m, 0.06) << "90 degrees to its right";
}

TEST(ServedRequests, TheRobotIsPutAndStaysWhatItsWheelsSay) {
  ClientOfHall client;
  const Pose2 start = client.robot.true_pose();
  const auto before = client.wheels_mm();
  client.put_at(5000, 300, 90);
  const Pose2 there = client.robot.true_pose();
  EXPECT_NEAR(there.x_m, 5.0, 1e-3);
  EXPECT_NEAR(there.y_m, 0.3, 1e-3);
  EXPECT_NEAR(there.heading_rad, radians(90.0), 1e-3);
  EXPECT_EQ(client.wheels_mm(), before) << "a hand turns no wheel";
  client.say(pioneer::arcos::encode({static_cast<std::uint8_t>(Command::sim_reset), {}}));
  client.run(0.02);
  EXPECT_NEAR(client.robot.true_pose().x_m, start.x_m, 1e-3);
  EXPECT_NEAR(client.robot.true_pose().heading_rad, start.heading_rad, 1e-3);
}

TEST(ServedRequests, TheRobotIsPutIntoNoWallAndNotOutside) {
  ClientOfHall client;
  const Pose2 start = client.robot.true_pose();
  for (const auto& [x_mm, y_mm] :
       {std::pair{5000, 1200}, {5000, 20000}, {-4000, 0}, {2000000000, -2000000000}}) {
    client.put_at(x_mm, y_mm, 0);
    EXPECT_NEAR(client.robot.true_pose().x_m, start.x_m, 1e-3) << x_mm << " " << y_mm;
    EXPECT_NEAR(client.robot.true_pose().y_m, start.y_m, 1e-3);
  }
}

TEST(ServedRequests, TheEncodersFollowEachWheel) {
  ClientOfHall client;
  client.put_at(10000, 0, 0);
  const auto drive = [&](Command order, int value, double seconds) {
    const auto before = client.wheels_mm();
    client.say(command(order, value));
    client.run(seconds);
    const auto after = client.wheels_mm();
    return std::pair{after.first - before.first, after.second - before.second};
  };
  const auto ahead = drive(Command::move, 500, 4.0);
  EXPECT_NEAR(ahead.first, 500.0, 10.0);
  EXPECT_NEAR(ahead.second, 500.0, 10.0);
  const auto turned = drive(Command::turn, 90, 4.0);
  EXPECT_NEAR(turned.first, -280.5, 6.0);
  EXPECT_NEAR(turned.second, 280.5, 6.0);
  const auto across = drive(Command::move, 400, 4.0);
  EXPECT_NEAR(across.first, 400.0, 10.0);
  EXPECT_NEAR(across.second, 400.0, 10.0);
}

TEST(ServedRequests, AnLms200IsServedInsteadOfTheHokuyo) {
  ServedDevices devices;
  devices.laser = pioneer::LaserKind::lms200;
  ClientOfHall client(devices);
  client.put_at(10000, 200, 0);
  client.robot.laser().receive(pioneer::lms200::install_mode());
  client.robot.laser().receive(pioneer::lms200::set_millimetres());
  client.robot.laser().receive(pioneer::lms200::set_variant(180, 50));
  client.robot.laser().receive(pioneer::lms200::continuous(true));
  client.run(0.5);
  pioneer::lms200::TelegramStream telegrams;
  telegrams.push(client.robot.laser().take_output());
  int scans = 0;
  while (const auto telegram = telegrams.next()) {
    const auto scan = pioneer::lms200::read_scan(*telegram);
    if (!scan) continue;
    ++scans;
    ASSERT_EQ(scan->ranges_m.size(), 361u);
    EXPECT_NEAR(scan->ranges_m.front(), open_hall().width_m / 2.0 + 0.2, 0.06);
    EXPECT_NEAR(scan->ranges_m.back(), open_hall().width_m / 2.0 - 0.2, 0.06);
  }
  EXPECT_NEAR(scans, 5, 1);
}

}  // namespace
}  // namespace striate::served
