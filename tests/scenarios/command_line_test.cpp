#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "tests/scenarios/striate_here.hpp"

namespace striate::scenarios {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

TEST(CommandLine, HelpTeachesAndVersionTells) {
  const Ended help = striate_here({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_THAT(help.out, AllOf(HasSubstr("striate run corridor --world corridor_a"),
                              HasSubstr("perceive"), HasSubstr("Exit codes")));
  const Ended version = striate_here({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.out, HasSubstr("striate 0."));
  EXPECT_EQ(striate_here({}).exit_code, 2);
  EXPECT_EQ(striate_here({"fly"}).exit_code, 2);
  EXPECT_EQ(striate_here({"run", "--sed", "7"}).exit_code, 2);
}

TEST(CommandLine, EveryShippedFilePassesTheCheck) {
  std::vector<std::string> arguments = {"check"};
  for (const char* folder : {"tasks", "worlds", "robots"}) {
    for (const auto& entry : std::filesystem::directory_iterator(std::string(STRIATE_SOURCE_DIR) +
                                                                 "/config/" + folder)) {
      if (entry.path().extension() == ".yaml") arguments.push_back(entry.path().string());
    }
  }
  ASSERT_GE(arguments.size(), 6U);
  const Ended ended = striate_here(arguments);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
}

TEST(CommandLine, ABrokenTaskIsToldWithItsPlacesAndNothingRuns) {
  const TemporaryFolder folder;
  const std::string task =
      folder.write("t.yaml", "striate: 1\ndo:\n  - fly: {}\n  - wait: {for: 3}\n");
  const std::string result = folder / "r.json";
  const Ended ended =
      striate_here({"run", task, "--world", "config/worlds/short.yaml", "--result", result});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_THAT(ended.err, AllOf(HasSubstr("t.yaml:3:5: error[T020]: unknown action 'fly'"),
                               HasSubstr("t.yaml:4:17: error[T014]: '3' has no unit")));
  EXPECT_FALSE(std::filesystem::exists(result));
}

TEST(CommandLine, ABrokenWorldIsToldWithAllItsPlaces) {
  const TemporaryFolder folder;
  const std::string world = folder.write(
      "w.yaml",
      "striate_world: 1\nname: w\ncorridor: {length: 60, width: 2.4 m, height: 2.7 m}\n"
      "dors: []\n");
  const Ended ended = striate_here({"run", "config/tasks/corridor.yaml", "--world", world});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_THAT(ended.err, AllOf(HasSubstr("w.yaml:3:20: error:"), HasSubstr("w.yaml:4:1: error:")));
}

TEST(CommandLine, BrokenSettingsAreToldWithAllTheirPlaces) {
  const TemporaryFolder folder;
  const std::string robot =
      folder.write("r.yaml", "safety:\n  stop: 6\n  slow_sped: 0.3 m/s\nfoo: 1\n");
  const Ended ended = striate_here({"config", "--robot", robot});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_THAT(ended.err,
              AllOf(HasSubstr("r.yaml:2:9: error: '6' has no unit"),
                    HasSubstr("r.yaml:3:3: error: unknown key 'slow_sped'"),
                    HasSubstr("did you mean 'slow_speed'?"), HasSubstr("r.yaml:4:1: error:")));
}

TEST(CommandLine, ConfigTellsEveryValueAndWhereItCameFrom) {
  const TemporaryFolder folder;
  const std::string robot = folder.write("r.yaml", "safety:\n  stop: 7 cm\n");
  const Ended ended = striate_here({"config", "--robot", robot});
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(ended.out, testing::ContainsRegex("safety.stop +0.07 m +[^\n]*r.yaml:2"));
  EXPECT_THAT(ended.out, testing::ContainsRegex("safety.slow_speed +0.3 m/s +default"));
}

TEST(CommandLine, SimRendersAPlaceAndRefusesNonsense) {
  const TemporaryFolder folder;
  const std::string image = folder / "v.png";
  const Ended good = striate_here(
      {"sim", "config/worlds/short.yaml", "--picture", image, "--at", "2 m, 0.2 m, 5 deg"});
  EXPECT_EQ(good.exit_code, 0) << good.err;
  EXPECT_GT(std::filesystem::file_size(image), 10000U);
  for (const auto& [at, says] : std::vector<std::pair<std::string, std::string>>{
           {"900 m, 0 m", "--at: 900 m, 0 m lies outside short"},
           {"-3 m, 0 m", "lies outside short"},
           {"2 m, 40 m", "--at: 2 m, 40 m lies outside short"}}) {
    const Ended outside =
        striate_here({"sim", "config/worlds/short.yaml", "--picture", image, "--at", at});
    EXPECT_EQ(outside.exit_code, 2) << at;
    EXPECT_THAT(outside.err, HasSubstr(says)) << at;
  }
  const Ended bad =
      striate_here({"sim", "config/worlds/short.yaml", "--picture", image, "--at", "2"});
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_THAT(bad.err, HasSubstr("12 m, 0.2 m, 5 deg"));
}

TEST(CommandLine, AResultThatCannotBeWrittenIsSaidBeforeAnythingMoves) {
  const Ended ended = striate_here({"run", "config/tasks/corridor.yaml", "--world",
                                    "config/worlds/short.yaml", "--result", "/proc/no/r.json"});
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_THAT(ended.err, HasSubstr("/proc/no/r.json: nothing can be written there"));
  EXPECT_THAT(ended.out, testing::IsEmpty());
}

/// Each row: a --left, a --right, and what the command must say of them. Empty: it must answer.
TEST(CommandLine, PerceiveRefusesOrAnswersHostileImages) {
  const TemporaryFolder folder;
  const auto write = [&](const std::string& name, const cv::Mat& image) {
    cv::imwrite(folder / name, image);
    return folder / name;
  };
  const auto cut = [&](const std::string& name, const std::string& whole) {
    const std::string bytes = read_text(whole);
    return folder.write(name, bytes.substr(0, bytes.size() / 2));
  };
  cv::Mat3b noise(120, 160);
  cv::theRNG().state = 3;
  cv::randu(noise, 0, 256);
  const std::string good = write("good.png", noise);
  std::string huge = read_text(good);
  huge[17] = huge[21] = '\x10';
  const struct {
    std::string left, right, says;
  } rows[] = {
      {cut("cut.png", good), good, "cut.png: is no image"},
      {good, cut("cut.jpg", write("good.jpg", noise)), "cut.jpg: is no image"},
      {good, cut("cut.ppm", write("good.ppm", noise)), "cut.ppm: is no image"},
      {folder.write("huge.png", huge), good, "huge.png: is 1048736 x 1048696 px"},
      {folder.write("huge.pgm", "P5 40000 40000 255\n"), good, "huge.pgm: is 40000 x 40000 px"},
      {write("one.png", cv::Mat1b(1, 1, uchar{9})), good, "one.png: is 1 x 1 px"},
      {good, write("small.png", cv::Mat1b(60, 80, uchar{9})), "small.png is 80 x 60"},
      {folder.write("nan.pfm", "Pf\n160 120\n-1\n" + std::string(4 * 160 * 120, '\xff')), good,
       "nan.pfm: has floating-point pixels"},
      {folder.write("text.png", "no image"), good, "text.png: is no image"},
      {folder.write("empty.png", ""), good, "empty.png: is no image"},
      {folder / "nowhere.png", good, "nowhere.png: no such file"},
      {write("deep.png", cv::Mat3w(120, 160, cv::Vec3w::all(40000))), good, ""},
      {write("grey.png", cv::Mat1b(120, 160, uchar{9})), good, ""},
      {write("alpha.png", cv::Mat4b(120, 160, cv::Vec4b(9, 9, 9, 0))), good, ""},
      {write("black.png", cv::Mat1b(120, 160, uchar{0})), folder / "black.png", ""},
      {write("white.png", cv::Mat1b(120, 160, uchar{255})), folder / "white.png", ""},
  };
  for (const auto& row : rows) {
    const Ended ended = striate_here(
        {"perceive", "--left", row.left, "--right", row.right, "--out", folder / "out"});
    EXPECT_EQ(ended.exit_code, row.says.empty() ? 0 : 2) << row.left << ": " << ended.err;
    EXPECT_THAT(ended.err, HasSubstr(row.says));
  }
}

/// A pair without any texture: nothing may be free, nothing may stand in the way.
TEST(CommandLine, PerceiveKnowsNothingOfABlankPair) {
  const TemporaryFolder folder;
  cv::imwrite(folder / "white.png", cv::Mat1b(120, 160, uchar{255}));
  const Ended ended = striate_here({"perceive", "--left", folder / "white.png", "--right",
                                    folder / "white.png", "--out", folder / "out", "--focal-px",
                                    "203", "--baseline-m", "0.12", "--camera-height-m", "1.2"});
  ASSERT_EQ(ended.exit_code, 0) << ended.err;
  const auto json = nlohmann::json::parse(read_text(folder / "out/obstacles.json"));
  EXPECT_TRUE(json["obstacles"].empty());
  for (const auto& column : json["columns"]) {
    EXPECT_TRUE(column["free_to"].is_null());
    EXPECT_TRUE(column["obstacle"].is_null());
  }
}

}  // namespace
}  // namespace striate::scenarios
