#include "striate/platform/pioneer/firmware/urg_device.hpp"

#include <gtest/gtest.h>

/// The Hokuyo as a stranger's program meets it, line by line.
namespace striate::pioneer {
namespace {

struct UrgLine {
  std::string say(const std::string& line) {
    const std::string text = line + "\n";
    device.receive(Bytes(text.begin(), text.end()));
    return heard();
  }
  std::string heard() {
    const Bytes bytes = device.take_output();
    return {bytes.begin(), bytes.end()};
  }
  std::string run(double seconds) {
    std::string all;
    for (double t = 0.0; t < seconds - 1e-9; t += 0.01) {
      now += std::chrono::milliseconds(10);
      device.set_time(now);
      if (device.measures(now)) device.step(now, std::vector<int>(device.rays(), 2000));
      all += heard();
    }
    return all;
  }
  UrgDevice device;
  TimePoint now{std::chrono::seconds(5)};
};

TEST(UrgDevice, SendsAsManyScansAsAreAskedForAndCountsThemDown) {
  UrgLine urg;
  EXPECT_EQ(urg.say("MD0044004600002;mine"), "MD0044004600002;mine\n00P\n\n");
  const std::string scans = urg.run(0.5);
  const std::size_t first = scans.find("MD0044004600001;mine\n99b\n");
  const std::size_t second = scans.find("MD0044004600000;mine\n99b\n");
  EXPECT_EQ(first, 0u);
  ASSERT_NE(second, std::string::npos);
  EXPECT_EQ(scans.find("MD", second + 2), std::string::npos) << "two";
  EXPECT_EQ(urg.say("GD0044004600"), "GD0044004600\n10Q\n\n") << "the laser is off after them";
  EXPECT_EQ(urg.say("MS0044004600000").substr(16), "00P\n\n");
  const std::string endless = urg.run(0.3);
  EXPECT_EQ(endless.find("MS0044004600000\n99b\n"), 0u);
  EXPECT_TRUE(urg.device.streams());
  EXPECT_EQ(urg.say("QT"), "QT\n00P\n\n");
  EXPECT_EQ(urg.run(0.3), "");
}

TEST(UrgDevice, GivesOneScanWithTheLaserOn) {
  UrgLine urg;
  EXPECT_EQ(urg.say("BM"), "BM\n00P\n\n");
  EXPECT_EQ(urg.say("BM;again"), "BM;again\n02R\n\n");
  EXPECT_EQ(urg.say("GS0044004501;x"), "") << "comes with the scan";
  const std::string scan = urg.run(0.2);
  EXPECT_EQ(scan.rfind("GS0044004501;x\n00P\n", 0), 0u);
  scip::ReplyStream stream;
  stream.push(Bytes(scan.begin(), scan.end()));
  const auto reply = stream.next();
  ASSERT_TRUE(reply);
  const auto read = scip::read_scan(*reply, {});
  ASSERT_TRUE(read);
  EXPECT_EQ(read->rays.size(), 2u);
  EXPECT_DOUBLE_EQ(read->rays[0].distance_m, 2.0);
}

TEST(UrgDevice, SaysWhichPartOfARequestIsWrong) {
  UrgLine urg;
  (void)urg.say("BM");
  const auto status = [&](const std::string& line) {
    return urg.say(line).substr(line.size() + 1, 2);
  };
  EXPECT_EQ(status("MDx044072500000"), "01");
  EXPECT_EQ(status("MD0044x72500000"), "02");
  EXPECT_EQ(status("MD00440725x0000"), "03");
  EXPECT_EQ(status("MD0044076900000"), "04");
  EXPECT_EQ(status("MD0700004400000"), "05");
  EXPECT_EQ(status("MD004407250x000"), "03");
  EXPECT_EQ(status("MD004407250"
                   "0x00"),
            "06");
  EXPECT_EQ(status("MD0044072500"
                   "0x0"),
            "07");
  EXPECT_EQ(status("GD0044076901"), "04");
  EXPECT_EQ(status("GD0700004401"), "05");
  EXPECT_EQ(status("GD004407"), "0C") << "too short";
  EXPECT_EQ(status("XX"), "0E");
  EXPECT_EQ(status("V"), "0E");
  EXPECT_EQ(status("VV;12345678901234567"), "0G") << "17 characters of the client's";
  EXPECT_FALSE(urg.device.streams());
  const std::string noise = "\xfa\xfb\x03";
  EXPECT_EQ(urg.say(noise), "") << "another device's protocol";
  EXPECT_EQ(status("BM"), "02");
}

TEST(UrgDevice, TellsItsTimeInClockModeAlone) {
  UrgLine urg;
  (void)urg.run(0.5);
  EXPECT_EQ(urg.say("TM1").substr(4, 2), "04");
  EXPECT_EQ(urg.say("TM2").substr(4, 2), "03");
  EXPECT_EQ(urg.say("TM0").substr(4, 2), "00");
  EXPECT_EQ(urg.say("TM0").substr(4, 2), "02");
  const std::string told = urg.say("TM1;7");
  ASSERT_EQ(told.substr(0, 10), "TM1;7\n00P\n");
  EXPECT_EQ(scip::decode(told.data() + 10, 4), 5500);
  EXPECT_EQ(urg.say("BM").substr(3, 2), "0B") << "it measures nothing meanwhile";
  EXPECT_EQ(urg.say("TM2").substr(4, 2), "00");
  EXPECT_EQ(urg.say("TM3").substr(4, 2), "01");
  EXPECT_EQ(urg.say("BM").substr(3, 2), "00");
}

TEST(UrgDevice, TellsItsStateAndTakesSpeedAndRate) {
  UrgLine urg;
  const auto status = [&](const std::string& line) {
    return urg.say(line).substr(line.size() + 1, 2);
  };
  EXPECT_NE(urg.say("II").find("LASR:OFF;7\n"), std::string::npos);
  EXPECT_EQ(status("CR05"), "00");
  EXPECT_EQ(status("CR05"), "03");
  EXPECT_EQ(status("CR11"), "02");
  EXPECT_EQ(status("CRxx"), "01");
  EXPECT_EQ(status("SS115200"), "00");
  EXPECT_EQ(status("SS115200"), "03");
  EXPECT_EQ(status("SS115201"), "02");
  EXPECT_EQ(status("SSfast!!"), "01");
  EXPECT_EQ(status("HS1"), "00");
  EXPECT_EQ(status("HS1"), "02");
  EXPECT_EQ(status("HS2"), "01");
  (void)urg.say("BM");
  const std::string told = urg.say("II;who");
  EXPECT_EQ(told.rfind("II;who\n00P\n", 0), 0u);
  for (const char* part :
       {"LASR:ON;", "570[rpm]", "SBPS:115200[bps];", "STAT:Sensor works well.;8"}) {
    EXPECT_NE(told.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(status("RS"), "00");
  const std::string fresh = urg.say("II");
  for (const char* part : {"LASR:OFF;", "600[rpm]", "SBPS:19200[bps];"}) {
    EXPECT_NE(fresh.find(part), std::string::npos) << part;
  }
}

TEST(UrgDevice, RebootsAtTheSecondWord) {
  UrgLine urg;
  (void)urg.say("BM");
  EXPECT_EQ(urg.say("RB"), "RB\n01Q\n\n");
  (void)urg.run(1.5);
  EXPECT_EQ(urg.say("RB"), "RB\n01Q\n\n") << "the first was too long ago";
  EXPECT_EQ(urg.say("BM").substr(3, 2), "02");
  EXPECT_EQ(urg.say("RB"), "RB\n00P\n\n");
  EXPECT_EQ(urg.say("BM").substr(3, 2), "00") << "the laser was off";
}

TEST(UrgDevice, ARayThatMeasuredNothingHidesNoneOfItsCluster) {
  UrgDevice device;
  const std::string ask = "BM\nGD0044004603\n";
  device.receive(Bytes(ask.begin(), ask.end()));
  std::vector<int> ranges(device.rays(), 0);
  ranges[0] = 0;
  ranges[1] = 5576;
  ranges[2] = 5411;
  const TimePoint now{std::chrono::seconds(5)};
  ASSERT_TRUE(device.measures(now));
  device.step(now, ranges);
  const Bytes bytes = device.take_output();
  const std::string said(bytes.begin(), bytes.end());
  const std::string range_of_5411 = {'0' + 1, '0' + (5411 / 64) % 64, '0' + 5411 % 64};
  EXPECT_NE(said.find("\n" + range_of_5411), std::string::npos) << said;
}

/// The mirror turns ten times a second, whoever asks.
TEST(UrgDevice, IsAskedNoFasterThanItsMirrorTurns) {
  UrgLine urg;
  (void)urg.say("BM");
  int scans = 0;
  for (int i = 0; i < 100; ++i) {
    (void)urg.say("GD0044004600");
    scans += urg.run(0.01).find("GD0044004600\n00P\n") == std::string::npos ? 0 : 1;
  }
  EXPECT_GE(scans, 9);
  EXPECT_LE(scans, 11);
}

}  // namespace
}  // namespace striate::pioneer
