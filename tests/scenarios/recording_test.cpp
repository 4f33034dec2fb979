#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/scenarios/striate_process.hpp"

/// A mission that is recorded, run again, and looked into.
namespace striate::scenarios {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

Ended record(const std::string& file, std::chrono::milliseconds interrupted_after = {}) {
  return striate(
      {"run", "config/tasks/corridor.yaml", "--world", "config/worlds/short.yaml", "--seed", "3",
       "--var", "way=3 m", "--no-emergency", "--quiet", "--record", file},
      {.after = interrupted_after, .once_there_is = interrupted_after.count() > 0 ? file : ""});
}

nlohmann::json json_of(const Ended& ended) {
  return nlohmann::json::parse(ended.out, nullptr, false);
}

class RecordedMission : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = std::make_unique<TemporaryFolder>();
    ended_ = record(file());
  }
  static void TearDownTestSuite() { folder_.reset(); }
  static std::string file() { return *folder_ / "run.rec"; }

  static std::unique_ptr<TemporaryFolder> folder_;
  static Ended ended_;
};

std::unique_ptr<TemporaryFolder> RecordedMission::folder_;
Ended RecordedMission::ended_;

TEST_F(RecordedMission, DecidesTheSameAgainBitForBit) {
  ASSERT_EQ(ended_.exit_code, 0) << ended_.err;
  const Ended again = striate({"replay", file(), "--json"});
  EXPECT_EQ(again.exit_code, 0) << again.out << again.err;
  const nlohmann::json json = json_of(again);
  EXPECT_EQ(json["identical"], true) << again.out;
  EXPECT_EQ(json["whole"], true);
  EXPECT_GT(json["cycles"], 70);
}

TEST_F(RecordedMission, OfWhichTheEndIsMissingIsReplayedUpToThere) {
  const TemporaryFolder folder;
  const std::string cut = folder / "cut.rec";
  fs::copy_file(file(), cut);
  fs::resize_file(cut, fs::file_size(cut) / 3);
  const Ended again = striate({"replay", cut});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.out, HasSubstr("cut off"));
  EXPECT_THAT(again.out, HasSubstr("the same in all cycles, bit for bit"));
}

TEST_F(RecordedMission, WithoutASingleCycleShowsNothing) {
  const TemporaryFolder folder;
  const std::string cut = folder / "cut.rec";
  fs::copy_file(file(), cut);
  bool found = false;
  for (std::uintmax_t size = fs::file_size(cut) / 2; size > 64 && !found; size /= 2) {
    fs::resize_file(cut, size);
    const Ended again = striate({"replay", cut, "--json"});
    if (again.exit_code == 2) break;
    if (json_of(again)["cycles"] != 0) continue;
    found = true;
    EXPECT_EQ(again.exit_code, 1);
    EXPECT_EQ(json_of(again)["identical"], false);
    EXPECT_THAT(striate({"replay", cut}).out, HasSubstr("the recording holds no cycle"));
  }
  EXPECT_TRUE(found);
}

TEST_F(RecordedMission, TellsWhatShortTermMemoryHeldAtAnyTime) {
  const TemporaryFolder folder;
  const std::string image = folder / "map.png";
  const Ended recalled = striate({"recall", file(), "--at", "6 s", "--json", "--picture", image});
  ASSERT_EQ(recalled.exit_code, 0) << recalled.err;
  const nlohmann::json state = json_of(recalled);
  EXPECT_NEAR(state["time_s"].get<double>(), 6.0, 0.11);
  EXPECT_EQ(state["polar_map"].size(), 16U);
  EXPECT_THAT(state["polar_map"].dump(), HasSubstr("."));
  EXPECT_GT(fs::file_size(image), 1000U);
  EXPECT_THAT(striate({"recall", file(), "--cycle", "60"}).out, HasSubstr("corridor"));
  const Ended late = striate({"recall", file(), "--at", "900 s"});
  EXPECT_EQ(late.exit_code, 2);
  EXPECT_THAT(late.err, HasSubstr("ends with cycle"));
}

TEST_F(RecordedMission, WithOtherSettingsSaysWhatIsDecidedOtherwise) {
  const TemporaryFolder folder;
  const std::string robot = folder.write("robot.yaml", "perception:\n  stereo:\n    mode: paper\n");
  const Ended again = striate({"replay", file(), "--robot", robot});
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_THAT(again.out, HasSubstr("stereo.mode"));
  EXPECT_THAT(again.out, HasSubstr("differ in"));
}

TEST(Recording, OfAnInterruptedMissionIsWhole) {
  const TemporaryFolder folder;
  const Ended ended = record(folder / "run.rec", std::chrono::milliseconds(2500));
  EXPECT_EQ(ended.exit_code, 130) << ended.err;
  const Ended again = striate({"replay", folder / "run.rec", "--json"});
  EXPECT_EQ(json_of(again)["identical"], true) << again.out << again.err;
  EXPECT_EQ(json_of(again)["whole"], true);
}

TEST(Recording, ThatCannotBeWrittenIsToldBeforeAnythingMoves) {
  const Ended ended = record("/dev/full");
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_THAT(ended.err, HasSubstr("cannot be written"));
}

TEST(RecallCommand, ShowsARunningMissionAndRefusesWhatIsNoMemory) {
  const TemporaryFolder folder;
  const std::string now = folder / "now.json";
  striate({"run", "config/tasks/corridor.yaml", "--world", "config/worlds/short.yaml", "--seed",
           "3", "--quiet", "--inspect", now},
          {.after = std::chrono::milliseconds(500), .once_there_is = now});
  const Ended recalled = striate({"recall", now});
  EXPECT_EQ(recalled.exit_code, 0) << recalled.err;
  EXPECT_THAT(recalled.out, HasSubstr("corridor"));
  const Ended wrong = striate({"recall", "README.md"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.err, HasSubstr("README.md: is neither a recording"));
}

}  // namespace
}  // namespace striate::scenarios
