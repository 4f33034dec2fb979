#include "striate/platform/pioneer/firmware/lms_device.hpp"

#include <gtest/gtest.h>

#include "striate/base/geometry.hpp"

/// The LMS-200 as a stranger's program meets it, telegram by telegram.
namespace striate::pioneer {
namespace {

struct SickLine {
  /// The data of the one reply, without its status byte; empty: none.
  Bytes say(Bytes data) {
    device.receive(lms200::encode({lms200::kToLaser, std::move(data)}));
    return heard();
  }
  Bytes heard() {
    lms200::TelegramStream stream;
    stream.push(device.take_output());
    auto telegram = stream.next();
    acknowledged = stream.counters().acknowledged;
    refused = stream.counters().refused;
    if (!telegram) return {};
    telegram->data.pop_back();
    return telegram->data;
  }
  std::optional<lms200::Scan> scan() {
    now += std::chrono::milliseconds(100);
    device.step(now, std::vector<double>(device.bearings_rad().size(), 3.21));
    lms200::TelegramStream stream;
    stream.push(device.take_output());
    const auto telegram = stream.next();
    return telegram ? lms200::read_scan(*telegram) : std::nullopt;
  }
  Bytes install() { return say({0x20, 0x00, 'S', 'I', 'C', 'K', '_', 'L', 'M', 'S'}); }
  LmsDevice device;
  TimePoint now{std::chrono::seconds(5)};
  std::uint64_t acknowledged = 0;
  std::uint64_t refused = 0;
};

TEST(LmsDevice, TellsItsTypeStatusAndConfiguration) {
  SickLine sick;
  const Bytes type = sick.say({0x3a});
  EXPECT_EQ(std::string(type.begin() + 1, type.end()), "LMS200;30106;V02.10 ");
  EXPECT_EQ(type[0], 0xba);
  EXPECT_EQ(sick.acknowledged, 1u);
  const Bytes status = sick.say({0x31});
  ASSERT_EQ(status.size(), 153u);
  EXPECT_EQ(status[0], 0xb1);
  EXPECT_EQ(status[1 + 7], 0x25) << "on request";
  EXPECT_EQ(status[1 + 106], 180);
  EXPECT_EQ(status[1 + 108], 100);
  EXPECT_EQ(status[1 + 115] | status[1 + 116] << 8, 0x8067) << "9600 baud";
  const Bytes configuration = sick.say({0x74});
  ASSERT_EQ(configuration.size(), 33u);
  EXPECT_EQ(configuration[0], 0xf4);
  EXPECT_EQ(configuration[1 + 6], 0) << "centimetres, as it is delivered";
}

TEST(LmsDevice, MeasuresInTheUnitAndFieldThatWereSet) {
  SickLine sick;
  (void)sick.say({0x20, 0x24});
  const auto centimetres = sick.scan();
  ASSERT_TRUE(centimetres);
  EXPECT_EQ(centimetres->ranges_m.size(), 181u);
  EXPECT_NEAR(centimetres->ranges_m[90], 3.21, 1e-9);
  EXPECT_EQ(sick.say({0x77, 0}), Bytes{0x92}) << "not outside the set-up";
  EXPECT_EQ(sick.install(), (Bytes{0xa0, 0}));
  Bytes millimetres(33, 0);
  millimetres[0] = 0x77;
  millimetres[7] = 1;
  EXPECT_EQ(sick.say(millimetres)[1], 1);
  EXPECT_EQ(sick.say({0x74})[1 + 6], 1);
  EXPECT_EQ(sick.say({0x3b, 100, 0, 25, 0}), (Bytes{0xbb, 1, 100, 0, 25, 0}));
  EXPECT_EQ(sick.say({0x3b, 180, 0, 25, 0})[1], 0) << "too fine for 180 degrees";
  EXPECT_EQ(sick.say({0x3b, 90, 0, 50, 0})[1], 0);
  const std::vector<double> bearings = sick.device.bearings_rad();
  ASSERT_EQ(bearings.size(), 401u);
  EXPECT_NEAR(bearings.front(), radians(-50.0), 1e-9);
  EXPECT_NEAR(bearings.back(), radians(50.0), 1e-9);
  (void)sick.say({0x30, 0x01});
  EXPECT_EQ(sick.scan()->ranges_m.size(), 401u);
  EXPECT_FALSE(sick.scan()) << "one";
}

TEST(LmsDevice, ChangesItsModeOnlyByTheRightWords) {
  SickLine sick;
  EXPECT_EQ(sick.say({0x20, 0x00, 'w', 'r', 'o', 'n', 'g'}), (Bytes{0xa0, 1}));
  EXPECT_EQ(sick.say({0x20, 0x24}), (Bytes{0xa0, 0}));
  EXPECT_TRUE(sick.device.streams());
  EXPECT_EQ(sick.say({0x20, 0x40}), (Bytes{0xa0, 0})) << "38400 baud";
  EXPECT_TRUE(sick.device.streams()) << "a rate is no mode";
  const Bytes status = sick.say({0x31});
  EXPECT_EQ(status[1 + 115] | status[1 + 116] << 8, 0x8019);
  EXPECT_EQ(sick.say({0x20, 0x25}), (Bytes{0xa0, 0}));
  EXPECT_FALSE(sick.device.streams());
  EXPECT_EQ(sick.say({0x99}), Bytes{0x92}) << "unknown";
}

TEST(LmsDevice, TellsItsNameAfterAReset) {
  SickLine sick;
  (void)sick.say({0x20, 0x24});
  EXPECT_EQ(sick.say({0x10}), Bytes{0x91});
  sick.device.step(sick.now, {});
  const Bytes name = sick.heard();
  ASSERT_FALSE(name.empty());
  EXPECT_EQ(name[0], 0x90);
  EXPECT_FALSE(sick.device.streams());
}

TEST(LmsDevice, RefusesAWrongSumAndHearsTheNextTelegram) {
  SickLine sick;
  Bytes wrong = lms200::encode({lms200::kToLaser, {0x31}});
  wrong.back() ^= 1;
  sick.device.receive(wrong);
  EXPECT_TRUE(sick.heard().empty());
  EXPECT_EQ(sick.refused, 1u);
  sick.device.receive(Bytes{0x02, 0x00, 0xff, 0x01});  // promises more than ever comes
  for (int i = 0; i < 5; ++i) (void)sick.scan();
  EXPECT_EQ(sick.say({0x3a})[0], 0xba);
}

}  // namespace
}  // namespace striate::pioneer
