#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/scenarios/striate_process.hpp"

// The command finds its files from wherever it is called.
namespace striate::scenarios {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

/// An empty working directory, and a home of its own.
class AnyDirectory : public testing::Test {
 protected:
  AnyDirectory() { fs::create_directory(where_ / "here"); }

  /// Runs the command in the empty directory.
  [[nodiscard]] Ended in_it(const std::string& arguments,
                            const std::string& program = STRIATE_BINARY) const {
    return run_program({"/bin/sh", "-c",
                        "unset XDG_CONFIG_HOME; HOME='" + where_.path() +
                            "/home'; export HOME; cd '" + where_.path() + "/here' && exec '" +
                            program + "' " + arguments});
  }
  void write(const std::string& file, const std::string& text) const {
    fs::create_directories(fs::path(where_ / file).parent_path());
    (void)where_.write(file, text);
  }
  /// The program as it is installed: X/bin and X/share/striate/config.
  [[nodiscard]] std::string installed() const {
    fs::create_directories(where_ / "x/bin");
    fs::create_directories(where_ / "x/share/striate");
    fs::copy(STRIATE_SOURCE_DIR "/config", where_ / "x/share/striate/config",
             fs::copy_options::recursive);
    fs::copy_file(STRIATE_BINARY, where_ / "x/bin/striate");
    return where_ / "x/bin/striate";
  }

  TemporaryFolder where_;
};

constexpr const char* kShortTask = "striate: 1\nmission: stand\ndo:\n  - wait: {for: 0.5 s}\n";

TEST_F(AnyDirectory, AShippedMissionRunsByItsPathAndByItsNameWithTheSameResult) {
  const Ended by_path = in_it(
      "run config/tasks/corridor.yaml --world config/worlds/short.yaml --seed 3 --quiet "
      "--var 'way=2.5 m' --result a.json");
  EXPECT_EQ(by_path.exit_code, 0) << by_path.err;
  const Ended by_name =
      in_it("run corridor --world short --seed 3 --quiet --var 'way=2.5 m' --result b.json");
  EXPECT_EQ(by_name.exit_code, 0) << by_name.err;
  const auto without_times = [&](const std::string& file) {
    auto json = nlohmann::json::parse(read_text(where_ / file));
    for (const char* of_the_machine : {"mean_cycle_ms", "realtime_factor"}) {
      json.erase(of_the_machine);
    }
    return json;
  };
  EXPECT_EQ(without_times("here/a.json"), without_times("here/b.json"));
}

TEST_F(AnyDirectory, ATrialFindsItsTaskAndItsWorldAndWritesWhereItWasCalled) {
  const Ended ended = in_it("trial --worlds short --runs 1 --out out --quiet");
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_TRUE(fs::exists(where_ / "here/out/runs.csv"));
  EXPECT_TRUE(fs::exists(where_ / "here/out/runs/short_seed001.json"));
}

TEST_F(AnyDirectory, AnObjectTrialFindsItsWorldsBeforeItJudgesWhatWasGiven) {
  const Ended ended = in_it("trial --objects --only no_such_thing --out out --quiet");
  EXPECT_EQ(ended.exit_code, 2);
  EXPECT_THAT(ended.err, HasSubstr("objects_teach.yaml: there is no object 'no_such_thing'"));
  const Ended nowhere = in_it("trial --objects --worlds nowhere,objects_find --out out");
  EXPECT_EQ(nowhere.exit_code, 2);
  EXPECT_THAT(nowhere.err, HasSubstr("nowhere: error: there is no such file; looked at:"));
}

TEST_F(AnyDirectory, TheDescriptorIsLearnedIntoTheWorkingDirectory) {
  EXPECT_EQ(in_it("learn-descriptor --help").exit_code, 0);
  const Ended ended = in_it("learn-descriptor --picture-count 2");
  EXPECT_EQ(ended.exit_code, 0) << ended.err;
  EXPECT_THAT(read_text(where_ / "here/striate_256.inc"), HasSubstr("--picture-count 2"));
}

TEST_F(AnyDirectory, CheckSaysWhichFileANameMeans) {
  const Ended good = in_it("check corridor.yaml short pioneer");
  EXPECT_EQ(good.exit_code, 0) << good.err;
  EXPECT_THAT(good.out, AllOf(HasSubstr("config/tasks/corridor.yaml: good"),
                              HasSubstr("config/worlds/short.yaml: good"),
                              HasSubstr("config/robots/pioneer.yaml: good")));
  const Ended bad = in_it("check coridor.yaml");
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_THAT(bad.err, AllOf(HasSubstr("home/.config/striate/tasks/coridor.yaml"),
                             HasSubstr("did you mean 'corridor'?")));
}

TEST_F(AnyDirectory, AFileOfYourOwnIsFoundUnlessAShippedOneHasItsName) {
  write("home/.config/striate/tasks/mine.yaml", kShortTask);
  write("home/.config/striate/tasks/corridor.yaml", "this: is no task\n");
  const Ended mine = in_it("run mine --world short --quiet");
  EXPECT_EQ(mine.exit_code, 0) << mine.err;
  EXPECT_EQ(in_it("task show corridor").exit_code, 0) << "the shipped one";
  const Ended paths = in_it("config --paths");
  EXPECT_EQ(paths.exit_code, 0) << paths.err;
  EXPECT_THAT(paths.out, ContainsRegex("mine +[^\n]*home/.config/striate/tasks/mine.yaml"));
  EXPECT_THAT(paths.out, ContainsRegex("Hidden[^\n]*\n[^\n]*striate/tasks/corridor.yaml"));
}

TEST_F(AnyDirectory, AnInstalledProgramFindsWhatWasInstalledWithIt) {
  const std::string program = installed();
  const Ended run = in_it("run corridor --world short --quiet --var 'way=2.5 m'", program);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const Ended paths = in_it("config --paths", program);
  EXPECT_THAT(paths.out, AllOf(HasSubstr("x/share/striate/config  (installed with the program)"),
                               HasSubstr("x/bin/config  (beside the program; not there)"),
                               ContainsRegex("corridor_a +[^\n]*x/share/striate/config/worlds")));
  EXPECT_EQ(paths.out.find(STRIATE_SOURCE_DIR "/config"), std::string::npos) << paths.out;
}

TEST_F(AnyDirectory, ATaskUsesAShippedOneAndItsRecordingReplaysWithoutIt) {
  write("here/mine.yaml", "striate: 1\nmission: mine\ndo:\n  - use: look.yaml\n    within: 11 s\n");
  const std::string program = installed();
  const Ended run = in_it("run mine.yaml --world short --quiet --record run.rec", program);
  EXPECT_EQ(run.exit_code, 0) << run.err;
  fs::remove_all(where_ / "x/share");
  const Ended gone = in_it("task show mine.yaml", program);
  EXPECT_EQ(gone.exit_code, 2);
  EXPECT_THAT(gone.err,
              HasSubstr("mine.yaml:4:10: error[T030]: there is no task file 'look.yaml'"));
  const Ended replay = in_it("replay run.rec", program);
  EXPECT_EQ(replay.exit_code, 0) << replay.out << replay.err;
}

}  // namespace
}  // namespace striate::scenarios
