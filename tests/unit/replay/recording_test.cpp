#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "striate/base/user_error.hpp"
#include "striate/platform/replay/recording_reader.hpp"
#include "striate/platform/replay/replay_robot.hpp"
#include "tests/reference/recorded_cycles.hpp"
#include "tests/reference/temporary_folder.hpp"

namespace striate::replay {
namespace {

using reference::a_cycle;
using reference::a_recording;
using reference::a_setup;
using testing::HasSubstr;

RecordingReader reader_of(const std::string& bytes) {
  return RecordingReader(std::make_unique<std::istringstream>(bytes), "run.rec");
}

/// The sentence that a recording is refused with, at its head or at a cycle; "" where it is not.
std::string refusal(const std::string& bytes) {
  try {
    RecordingReader reader = reader_of(bytes);
    RecordedCycle cycle;
    while (reader.next(cycle)) {
    }
  } catch (const UserError& error) {
    return error.what();
  }
  return {};
}

/// The bytes of a cycle: two cycles are the same when these are.
std::vector<std::uint8_t> bytes_of(const RecordedCycle& cycle) {
  std::vector<std::uint8_t> payload;
  encode(cycle, false, payload);
  return payload;
}

bool same_image(const cv::Mat3b& a, const cv::Mat3b& b) {
  return a.size() == b.size() && std::equal(a.begin(), a.end(), b.begin());
}

template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}

bool same_scan(const RangeScan& a, const RangeScan& b) {
  return a.stamp == b.stamp && std::equal(a.readings.begin(), a.readings.end(), b.readings.begin(),
                                          b.readings.end(), same_bits<RangeReading>);
}

TEST(Recording, GivesBackEveryFieldOfTheSensesBitForBit) {
  RecordingReader reader = reader_of(a_recording(3));
  RecordedCycle cycle;
  for (std::uint64_t number = 1; number <= 3; ++number) {
    ASSERT_TRUE(reader.next(cycle));
    const RecordedCycle original = a_cycle(number);
    const Senses& a = original.senses;
    const Senses& b = cycle.senses;
    EXPECT_EQ(cycle.number, number);
    EXPECT_EQ(a.now, b.now);
    EXPECT_EQ(a.stereo.stamp, b.stereo.stamp);
    EXPECT_TRUE(same_image(a.stereo.left, b.stereo.left));
    EXPECT_TRUE(same_image(a.stereo.right, b.stereo.right));
    EXPECT_TRUE(same_bits(a.stereo.focal_px, b.stereo.focal_px));
    EXPECT_TRUE(same_bits(a.stereo.centre_u_px, b.stereo.centre_u_px));
    EXPECT_TRUE(same_bits(a.stereo.centre_v_px, b.stereo.centre_v_px));
    EXPECT_TRUE(same_bits(a.stereo.baseline_m, b.stereo.baseline_m));
    EXPECT_TRUE(same_bits(a.stereo.head, b.stereo.head));
    EXPECT_TRUE(same_bits(a.odometry, b.odometry));
    EXPECT_TRUE(same_scan(a.sonar, b.sonar));
    EXPECT_TRUE(same_scan(a.laser, b.laser));
    EXPECT_TRUE(same_bits(a.head, b.head));
    EXPECT_TRUE(same_bits(a.battery_v, b.battery_v));
    EXPECT_EQ(a.bumper, b.bumper);
    EXPECT_EQ(a.motors_stalled, b.motors_stalled);
    EXPECT_EQ(bytes_of(original), bytes_of(cycle));  // the decision too
    EXPECT_EQ(cycle.decision.why, "goes round \xC3\xBC");
    EXPECT_TRUE(cycle.decision.interrupted);
  }
  EXPECT_FALSE(reader.next(cycle));
  EXPECT_EQ(reader.ending(), Ending::closed);
  EXPECT_EQ(reader.lost(), 7U);
}

TEST(Recording, GivesBackWhatTheRunWasBegunWith) {
  const RecordingReader reader = reader_of(a_recording(0));
  EXPECT_EQ(encode(reader.setup()), encode(a_setup()));
  EXPECT_EQ(reader.setup().task_files.at(1).first, "parts/back.yaml");
  EXPECT_EQ(reader.setup().seed, a_setup().seed);
  EXPECT_EQ(reader.setup().robot.cycle, Duration(77'000'001));
}

TEST(Recording, OfABodyWithOneEyeOrNoneImagesStayEmpty) {
  RecordedCycle original = a_cycle(1);
  original.senses.stereo.right.release();
  RecordedCycle read;
  decode_cycle(bytes_of(original), read);
  EXPECT_FALSE(read.senses.stereo.left.empty());
  EXPECT_TRUE(read.senses.stereo.right.empty());
  original.senses.stereo.left.release();
  decode_cycle(bytes_of(original), read);
  EXPECT_TRUE(read.senses.stereo.left.empty());
}

TEST(Recording, AnImageThatIsTheSameAsBeforeIsNotWrittenAgain) {
  RecordedCycle original = a_cycle(1);
  std::vector<std::uint8_t> first;
  std::vector<std::uint8_t> second;
  encode(original, false, first);
  encode(original, true, second);
  EXPECT_LT(second.size() + 3000, first.size());
  RecordedCycle read;
  decode_cycle(first, read);
  decode_cycle(second, read);
  EXPECT_TRUE(same_image(read.senses.stereo.right, original.senses.stereo.right));
  RecordedCycle fresh;
  EXPECT_THROW(decode_cycle(second, fresh), BadBytes);
}

TEST(Recording, CutOffAnywhereIsReadUpToItsLastWholeCycle) {
  const std::string whole = a_recording(3, false);
  const std::size_t head = a_recording(0, false).size();
  const std::size_t one = (whole.size() - head) / 3;
  for (std::size_t size = head; size < whole.size(); size += 97) {
    RecordingReader reader = reader_of(whole.substr(0, size));
    RecordedCycle cycle;
    std::size_t count = 0;
    while (reader.next(cycle)) ++count;
    EXPECT_EQ(reader.ending(), Ending::cut_off);
    // The cycles differ by a few bytes, as their images do.
    EXPECT_NEAR(static_cast<double>(count), static_cast<double>((size - head) / one), 1.0) << size;
  }
}

TEST(Recording, AFlippedByteAnywhereIsFoundAndItsPlaceTold) {
  const std::string good = a_recording(2);
  for (std::size_t at = 0; at < good.size(); at += 53) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 0x10);
    EXPECT_NE(refusal(bad), "") << at;
  }
  std::string bad = good;
  bad[bad.size() - 200] = static_cast<char>(bad[bad.size() - 200] ^ 1);
  EXPECT_THAT(refusal(bad), HasSubstr("is damaged at byte"));
  EXPECT_THAT(refusal(bad), HasSubstr("after cycle 1, which is good: the checksum is wrong"));
}

TEST(Recording, OfANewerVersionIsRefusedWithBothNumbers) {
  std::string newer = a_recording(1);
  newer[kMagic.size()] = 2;
  EXPECT_THAT(refusal(newer), HasSubstr("version 2 of the format, this one reads 1"));
}

TEST(Recording, AForeignOrEmptyFileIsRefused) {
  EXPECT_THAT(refusal("SQLite format 3, and so on, and on"), HasSubstr("is no recording of a run"));
  EXPECT_THAT(refusal(""), HasSubstr("is no recording of a run"));
  EXPECT_THROW(RecordingReader("/nowhere/run.rec"), UserError);
  EXPECT_THROW(RecordingReader("/tmp"), UserError);
  const reference::TemporaryFolder folder;
  EXPECT_TRUE(is_recording(folder.write("a", a_recording(0))));
  EXPECT_FALSE(is_recording(folder.write("b", "striate")));
  EXPECT_FALSE(is_recording(folder / "none"));
}

TEST(Recording, CyclesThatDoNotFollowEachOtherAreDamage) {
  std::vector<std::uint8_t> bytes = file_head();
  append_chunk(bytes, Chunk::setup, encode(a_setup()));
  for (const std::uint64_t number : {5, 5}) {
    append_chunk(bytes, Chunk::cycle, bytes_of(a_cycle(number)));
  }
  EXPECT_THAT(refusal({bytes.begin(), bytes.end()}), HasSubstr("do not follow each other"));
}

TEST(Recording, KeepsTheWholeRobotAndReadsSetupsFromBeforeItCouldBeAnother) {
  RecordedSetup setup = a_setup();
  setup.robot.view_rad = 1.1;
  setup.robot.resting_tilt_rad = -0.05;
  setup.robot.corner_m = 0.07;
  std::vector<std::uint8_t> bytes = encode(setup);
  EXPECT_EQ(decode_setup(bytes).robot.view_rad, 1.1);
  EXPECT_EQ(decode_setup(bytes).robot.resting_tilt_rad, -0.05);
  EXPECT_EQ(decode_setup(bytes).robot.corner_m, 0.07);
  bytes.resize(bytes.size() - 3 * sizeof(double));
  const RecordedSetup old = decode_setup(bytes);
  EXPECT_EQ(old.robot.view_rad, RobotDescription{}.view_rad);
  EXPECT_EQ(old.robot.front_m, setup.robot.front_m);
  bytes.resize(bytes.size() + sizeof(double));
  EXPECT_THROW((void)decode_setup(bytes), BadBytes);
}

TEST(ReplayRobot, FeelsWhatWasFeltThenWhateverItIsTold) {
  RecordingReader reader = reader_of(a_recording(2));
  ReplayRobot robot(reader);
  EXPECT_EQ(robot.description().front_m, 0.123);
  Senses senses;
  ASSERT_TRUE(robot.read_ahead());
  EXPECT_EQ(robot.cycle().number, 1U);
  ASSERT_TRUE(robot.sense(senses));
  robot.send({1.0, 1.0, 0.0, 0.0});
  EXPECT_EQ(senses.now, a_cycle(1).senses.now);
  EXPECT_EQ(robot.clock().now(), senses.now);
  ASSERT_TRUE(robot.sense(senses));
  EXPECT_EQ(senses.now, a_cycle(2).senses.now);
  EXPECT_FALSE(robot.sense(senses));
}

TEST(Recording, NumbersThatCannotBeAreDamageThoughTheChecksumsAreRight) {
  using Change = void (*)(RecordedSetup&, RecordedCycle&);
  const std::vector<std::pair<const char*, Change>> changes = {
      {"focal length", [](auto&, auto& c) { c.senses.stereo.focal_px = 0.01; }},
      {"focal length", [](auto&, auto& c) { c.senses.stereo.focal_px = 4e6; }},
      {"focal length", [](auto&, auto& c) { c.senses.stereo.focal_px = std::nan(""); }},
      {"principal point", [](auto&, auto& c) { c.senses.stereo.centre_v_px = -1e9; }},
      {"distance of its eyes", [](auto&, auto& c) { c.senses.stereo.baseline_m = 1e-300; }},
      {"head's tilt", [](auto&, auto& c) { c.senses.stereo.head.tilt_rad = 3.0; }},
      {"odometry's x", [](auto&, auto& c) { c.senses.odometry.pose.x_m = 1e300; }},
      {"odometry's heading",
       [](auto&, auto& c) { c.senses.odometry.pose.heading_rad = std::nan(""); }},
      {"the laser", [](auto&, auto& c) { c.senses.laser.readings.at(0).bearing_rad = 1.0 / 0.0; }},
      {"has a time", [](auto&, auto& c) { c.senses.now = TimePoint::max(); }},
      {"has a time", [](auto&, auto& c) { c.senses.stereo.stamp = TimePoint::min(); }},
      {"camera's height", [](auto& s, auto&) { s.robot.camera_height_m = 0.0; }},
      {"robot's rear", [](auto& s, auto&) { s.robot.rear_m = 1e9; }},
      {"its cycle", [](auto& s, auto&) { s.robot.cycle = Duration(0); }}};
  for (const auto& [what, change] : changes) {
    RecordedSetup setup = a_setup();
    RecordedCycle cycle = a_cycle(1);
    EXPECT_EQ(refusal(reference::recording_of(setup, {cycle})), "") << what;
    change(setup, cycle);
    EXPECT_THAT(refusal(reference::recording_of(setup, {cycle})),
                testing::AllOf(HasSubstr("run.rec: is damaged"), HasSubstr(what)));
  }
}

TEST(Recording, APipeOrADeviceIsNoRecordingAndIsNotWaitedFor) {
  EXPECT_THROW(RecordingReader("/dev/zero"), UserError);
}

}  // namespace
}  // namespace striate::replay
