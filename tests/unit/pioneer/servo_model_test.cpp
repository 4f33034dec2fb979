#include <gtest/gtest.h>

#include "striate/platform/pioneer/firmware/servo_bus.hpp"

/// The AX-12A as a stranger's program meets it, byte by byte.
namespace striate::pioneer {
namespace {

using dynamixel::Error;
using dynamixel::Instruction;
using dynamixel::Register;

struct ServoLine {
  /// The one reply, or nothing.
  std::optional<dynamixel::Packet> say(std::uint8_t id, Instruction instruction, Bytes parameters) {
    bus.receive(dynamixel::encode({id, static_cast<std::uint8_t>(instruction), parameters}));
    return reply();
  }
  std::optional<dynamixel::Packet> reply() {
    dynamixel::PacketStream stream;
    stream.push(bus.take_output());
    const auto first = stream.next();
    EXPECT_FALSE(stream.next()) << "one reply at most";
    return first;
  }
  int error(Instruction instruction, const Bytes& parameters) {
    const auto said = say(1, instruction, parameters);
    return said ? said->code : -1;
  }
  int write(std::uint8_t address, const Bytes& values) {
    Bytes parameters{address};
    append(parameters, values);
    return error(Instruction::write, parameters);
  }
  Bytes read(std::uint8_t address, std::uint8_t count) {
    const auto said = say(1, Instruction::read, {address, count});
    return said ? said->parameters : Bytes{};
  }
  void run(double seconds) {
    for (double t = 0.0; t < seconds - 1e-9; t += 0.01) bus.step(std::chrono::milliseconds(10));
  }
  ServoBus bus{{ServoModel(1, 0.0), ServoModel(2, 0.0)}};
};

TEST(ServoModel, TellsTheControlTableOfAnAx12a) {
  ServoLine line;
  const Bytes told = line.read(0, 19);
  EXPECT_EQ(told, (Bytes{12, 0, 24, 1, 1, 250, 0, 0, 255, 3, 0, 70, 60, 140, 255, 3, 2, 36, 36}));
  EXPECT_EQ(line.read(24, 6), (Bytes{0, 0, 1, 1, 32, 32}));
  EXPECT_EQ(line.read(Register::torque_limit, 2), (Bytes{255, 3}));
  EXPECT_EQ(line.read(Register::punch, 2), (Bytes{32, 0}));
  EXPECT_EQ(line.say(1, Instruction::read, {48, 3})->code, Error::range) << "beyond the table";
}

TEST(ServoModel, RefusesWhatIsOutOfRangeAndChangesNothing) {
  ServoLine line;
  EXPECT_EQ(line.write(Register::goal_position, {0xd0, 7}), Error::range);
  EXPECT_EQ(line.read(Register::goal_position, 2), (Bytes{0, 2}));
  EXPECT_EQ(line.write(Register::cw_limit, {44, 1}), 0);
  EXPECT_EQ(line.write(Register::goal_position, {200, 0}), Error::angle_limit);
  EXPECT_EQ(line.write(Register::goal_position, {200, 0, 50, 0}), Error::angle_limit);
  EXPECT_EQ(line.read(Register::moving_speed, 2), (Bytes{0, 0})) << "nothing of it";
  line.run(1.0);
  EXPECT_NEAR(line.bus.servos[0].angle_rad(), 0.0, 0.01);
  for (const std::uint8_t only_read :
       {Register::model, Register::firmware, Register::position, Register::speed, Register::load,
        Register::voltage, Register::temperature, Register::moving}) {
    EXPECT_EQ(line.write(only_read, {1}), Error::range) << int{only_read};
  }
  EXPECT_EQ(line.write(Register::goal_position, {0}), Error::range) << "half a word";
  EXPECT_EQ(line.write(Register::cw_slope, {0}), Error::range);
  EXPECT_EQ(line.write(Register::status_level, {3}), Error::range);
  EXPECT_EQ(line.write(Register::id, {254}), Error::range);
}

TEST(ServoModel, TellsHowFastItTurnsAndWhichWay) {
  ServoLine line;
  EXPECT_EQ(line.write(Register::goal_position, {0, 3, 50, 0}), 0);
  line.run(0.2);
  EXPECT_EQ(line.read(Register::speed, 2), (Bytes{50, 0}));
  EXPECT_EQ(line.read(Register::moving, 1), Bytes{1});
  EXPECT_EQ(line.write(Register::goal_position, {0, 1, 50, 0}), 0);
  line.run(0.2);
  EXPECT_EQ(line.read(Register::speed, 2), (Bytes{50, 4})) << "bit 10: clockwise";
  line.run(20.0);
  EXPECT_EQ(line.read(Register::speed, 2), (Bytes{0, 0}));
  EXPECT_EQ(line.read(Register::moving, 1), Bytes{0});
}

TEST(ServoModel, WaitsWithARegisteredWriteForAction) {
  ServoLine line;
  EXPECT_EQ(line.error(Instruction::action, {}), Error::instruction) << "nothing is registered";
  EXPECT_EQ(line.error(Instruction::register_write, {Register::goal_position, 0, 3}), 0);
  EXPECT_EQ(line.read(Register::registered, 1), Bytes{1});
  line.run(0.5);
  EXPECT_EQ(line.bus.servos[0].speed_rad_s(), 0.0);
  EXPECT_FALSE(line.say(dynamixel::kBroadcast, Instruction::action, {})) << "none replies to all";
  line.run(0.1);
  EXPECT_GT(line.bus.servos[0].speed_rad_s(), 0.0);
  EXPECT_EQ(line.read(Register::registered, 1), Bytes{0});
  EXPECT_EQ(line.error(Instruction::register_write, {Register::goal_position, 0, 9}), Error::range);
}

TEST(ServoModel, RepliesAsItsStatusReturnLevelSays) {
  ServoLine line;
  (void)line.write(Register::status_level, {1});
  EXPECT_EQ(line.write(Register::led, {1}), -1) << "silent";
  EXPECT_EQ(line.read(Register::led, 1), Bytes{1}) << "but done";
  (void)line.write(Register::status_level, {0});
  EXPECT_TRUE(line.read(Register::led, 1).empty());
  EXPECT_EQ(line.error(Instruction::ping, {}), 0) << "always";
}

TEST(ServoModel, RefusesUnknownInstructionsAndWrongSums) {
  ServoLine line;
  EXPECT_EQ(line.error(static_cast<Instruction>(0x42), {}), Error::instruction);
  EXPECT_EQ(line.error(Instruction::write, {}), Error::instruction);
  Bytes wrong = dynamixel::ping(1);
  wrong.back() ^= 1;
  line.bus.receive(wrong);
  ASSERT_EQ(line.reply().value_or(dynamixel::Packet{}).code, Error::checksum);
  EXPECT_EQ(line.error(Instruction::ping, {}), 0) << "and goes on";
  wrong[2] = 9;  // another's
  line.bus.receive(wrong);
  EXPECT_FALSE(line.reply());
}

TEST(ServoModel, IsNewAfterReset) {
  ServoLine line;
  (void)line.write(Register::cw_limit, {44, 1});
  EXPECT_EQ(line.say(2, Instruction::reset, {})->code, 0);
  EXPECT_EQ(line.bus.servos[1].id(), 1) << "the id of a new servo";
  EXPECT_FALSE(line.say(dynamixel::kBroadcast, Instruction::reset, {}));
  line.bus.servos[1].connected = false;  // two with one id would speak at once
  EXPECT_EQ(line.read(Register::cw_limit, 2), (Bytes{0, 0}));
}

TEST(ServoModel, LockedTakesOnlyWhatMovesIt) {
  ServoLine line;
  EXPECT_EQ(line.write(Register::lock, {1}), 0);
  EXPECT_EQ(line.write(Register::punch, {64, 0}), Error::range) << "as the manual's example 20";
  EXPECT_EQ(line.write(Register::lock, {0}), Error::range) << "only without current";
  EXPECT_EQ(line.write(Register::goal_position, {0, 3}), 0);
}

TEST(ServoModel, TellsWhatItsLimitsSay) {
  ServoLine line;
  EXPECT_EQ(line.write(Register::least_voltage, {130}), 0);
  line.run(0.01);
  EXPECT_EQ(line.error(Instruction::ping, {}), Error::voltage);
  EXPECT_EQ(line.write(Register::most_temperature, {20}), Error::voltage);
  (void)line.write(Register::goal_position, {0, 3});
  line.run(0.05);
  EXPECT_EQ(line.error(Instruction::ping, {}), Error::voltage | Error::overheat);
  EXPECT_EQ(line.bus.servos[0].speed_rad_s(), 0.0) << "its shutdown mask has heat";
}

TEST(ServoModel, WithoutAngleLimitsIsAWheel) {
  ServoLine line;
  EXPECT_EQ(line.write(Register::moving_speed, {50, 4}), Error::range);
  EXPECT_EQ(line.write(Register::ccw_limit, {0, 0}), 0);
  EXPECT_EQ(line.write(Register::torque_enable, {1}), 0);
  EXPECT_EQ(line.write(Register::moving_speed, {50, 4}), 0);
  line.run(0.2);
  EXPECT_LT(line.bus.servos[0].angle_rad(), -0.05) << "clockwise";
}

TEST(ServoBus, HalfAPacketSwallowsNothing) {
  ServoLine line;
  line.bus.receive(Bytes{0xff, 0xff, 1, 200, 3});
  line.run(0.2);
  EXPECT_EQ(line.error(Instruction::ping, {}), 0);
}

TEST(ServoBus, WritesSeveralAtOnceWithoutAReply) {
  ServoLine line;
  line.bus.receive(dynamixel::move({{1, 0.3, 1.0}, {2, -0.3, 1.0}}));
  EXPECT_FALSE(line.reply());
  line.run(1.0);
  EXPECT_NEAR(line.bus.servos[0].angle_rad(), 0.3, 0.01);
  EXPECT_NEAR(line.bus.servos[1].angle_rad(), -0.3, 0.01);
}

}  // namespace
}  // namespace striate::pioneer
