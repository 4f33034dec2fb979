#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/scenarios/striate_process.hpp"

namespace striate::scenarios {
namespace {

using testing::HasSubstr;

const std::vector<std::string> kTeach = {"teach",   "red_book",
                                         "--task",  "config/tasks/teach.yaml",
                                         "--robot", "config/robots/sharp_eyes.yaml",
                                         "--world", "config/worlds/objects_teach.yaml"};

nlohmann::json memory_json(const std::string& file, std::vector<std::string> words) {
  words.insert(words.begin(), {"memory", file});
  words.emplace_back("--json");
  const Ended ended = striate(words);
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  return nlohmann::json::parse(ended.out);
}

TEST(LiveTeaching, TheRobotLooksFromAllSidesAndKnowsTheThingAgainOnItsNextMission) {
  const TemporaryFolder folder;
  const std::string file = folder / "home.db";
  std::vector<std::string> words = kTeach;
  words.insert(words.end(), {"--yes", "--memory", file});
  const Ended taught = striate(words);
  ASSERT_EQ(taught.exit_code, 0) << taught.err;
  EXPECT_THAT(taught.out, HasSubstr("red_book: new, 4 views added"));
  EXPECT_EQ(memory_json(file, {"show", "red_book"}).at("looks").size(), 4U);

  const std::string task = folder.write("t.yaml", "striate: 1\ndo:\n  - wait: {for: 2 s}\n");
  const Ended run = striate({"run", task, "--world", "config/worlds/objects_teach.yaml", "--robot",
                             "config/robots/sharp_eyes.yaml", "--memory", file, "--quiet"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const nlohmann::json episodes = memory_json(file, {"episodes"});
  ASSERT_EQ(episodes.size(), 4U) << "taught, start, recognised, end";
  EXPECT_EQ(episodes[2].at("kind"), "recognised");
  EXPECT_EQ(episodes[2].at("landmark"), "red_book");
  EXPECT_THAT(episodes[2].at("text").get<std::string>(), HasSubstr("1.5 m away"));
}

TEST(LiveTeaching, NeedsATaskAndAWorld) {
  for (const char* option : {"--task", "--world"}) {
    const Ended ended = striate({"teach", "x", option, "config/tasks/teach.yaml", "--yes"});
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_THAT(ended.err, HasSubstr("needs --task and --world"));
  }
}

TEST(ObjectTrial, ABookThatWasTaughtIsRecognisedInTheOtherWorld) {
  const TemporaryFolder folder;
  const Ended ended =
      striate({"trial", "--objects", "--only", "red_book", "--quiet", "--out", folder / "out"});
  EXPECT_EQ(ended.exit_code, 0) << ended.out << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("red_book"));
  EXPECT_THAT(read_text(folder / "out/objects.csv"), HasSubstr("recognised"));
  EXPECT_EQ(striate({"trial", "--objects", "--only", "spoon", "--out", folder / "out"}).exit_code,
            2);
}

}  // namespace
}  // namespace striate::scenarios
