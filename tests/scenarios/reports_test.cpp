#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/scenarios/striate_process.hpp"

/// Whatever only reports a mission may fail: the mission drives on, what was lost is said once in
/// the end, and the exit code tells.
namespace striate::scenarios {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Two metres and a half, since nothing here depends on the way.
constexpr const char* kShortRun =
    "\"$striate\" run config/tasks/corridor.yaml --world config/worlds/short.yaml --seed 3 "
    "--var 'way=2.5 m' ";

/// @return what the mission wrote of itself
nlohmann::json result_of(const std::string& words, Ended& ended) {
  const TemporaryFolder folder;
  ended = bash("cd \"" STRIATE_SOURCE_DIR "\"; r=" + (folder / "r.json") + "; f=" + (folder / "f") +
               "; mkdir $f; " + words);
  return nlohmann::json::parse(read_text(folder / "r.json"), nullptr, false);
}

void expect_success(const nlohmann::json& result, const std::string& words) {
  ASSERT_TRUE(result.is_object()) << words;
  EXPECT_EQ(result.at("outcome"), "success") << words;
  EXPECT_GT(result.at("distance_m").get<double>(), 2.5) << words;
}

TEST(Reports, AStandardErrorThatCannotBeWrittenEndsNoMission) {
  for (const std::string where : {"2> /dev/full", "2>&-", "2>&1 > /dev/null | true"}) {
    const std::string words =
        kShortRun + std::string("--result $r ") + where + "; exit ${PIPESTATUS[0]}";
    Ended ended;
    expect_success(result_of(words, ended), words);
    EXPECT_EQ(ended.exit_code, 1) << words;
  }
}

TEST(Reports, AStandardOutputThatCannotBeWrittenEndsNoMission) {
  for (const std::string where : {"> /dev/full", ">&-", "--json > /dev/full"}) {
    const std::string words = kShortRun + std::string("--result $r ") + where;
    Ended ended;
    expect_success(result_of(words, ended), words);
    EXPECT_EQ(ended.exit_code, 1) << words;
    EXPECT_THAT(ended.err, HasSubstr("standard output cannot be written")) << words;
  }
}

TEST(Reports, AnInspectionThatCannotBeWrittenIsSaidOnce) {
  Ended ended;
  expect_success(
      result_of(kShortRun + std::string("--quiet --result $r --inspect /dev/full"), ended),
      "--inspect");
  EXPECT_EQ(ended.exit_code, 1);
  const std::size_t first = ended.err.find("/dev/full: cannot be written");
  EXPECT_NE(first, std::string::npos) << ended.err;
  EXPECT_EQ(ended.err.find("/dev/full", first + 1), std::string::npos) << ended.err;
}

TEST(Reports, FilesThatReachTheirLimitEndNoMissionAndAreSaidOnceEach) {
  Ended ended;
  const std::string words = "ulimit -f 64; " + std::string(kShortRun) +
                            "--quiet --result $r --record $f/r.rec --pictures $f/p "
                            "--picture-every 5 --inspect $f/now.json --mcap $f/r.mcap";
  expect_success(result_of(words, ended), words);
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_THAT(ended.err, HasSubstr("the recording: "));
  EXPECT_THAT(ended.err, HasSubstr("the pictures: "));
  EXPECT_THAT(ended.err, HasSubstr("the MCAP file: "));
  EXPECT_THAT(ended.err, HasSubstr("r.mcap: "));
}

TEST(Reports, AFolderThatIsGoneEndsNoMission) {
  Ended ended;
  const std::string words =
      kShortRun + std::string(
                      "--var 'way=11 m' --quiet --result $r --pictures $f/p "
                      "--picture-every 5 & until ls $f/p/* 2> $f/no; do sleep 0.1; done; "
                      "rm -r $f/p; wait $!");
  expect_success(result_of(words, ended), words);
  EXPECT_EQ(ended.exit_code, 1);
  EXPECT_THAT(ended.err, HasSubstr("the pictures: "));
}

/// What is printed must not land in a file that was given the number of a closed stream.
TEST(Reports, AClosedStandardErrorDoesNotPrintIntoTheMemory) {
  const TemporaryFolder folder;
  const Ended ended =
      bash("cd \"" STRIATE_SOURCE_DIR "\"; " + std::string(kShortRun) + "--memory " +
           (folder / "m.db") + " --record " + (folder / "r.rec") + " 2>&- >&-");
  EXPECT_EQ(ended.exit_code, 1);
  const Ended check = striate({"memory", folder / "m.db", "check"});
  EXPECT_EQ(check.exit_code, 0) << check.out << check.err;
  EXPECT_THAT(read_text(folder / "r.rec"), Not(HasSubstr("ms a cycle")));
}

}  // namespace
}  // namespace striate::scenarios
