#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scenarios/refused.hpp"

namespace striate::scenarios {
namespace {

using testing::HasSubstr;

void expect_refused_there(const Words& words, const std::string& path) {
  expect_refused({{with(words, path), path + ": "}});
}

const Words kRun = {"run", "config/tasks/corridor.yaml", "--world", "config/worlds/short.yaml"};

Words run_with(const std::string& option) {
  return with(kRun, option);
}

/// Those whose last word is the file to write.
const std::vector<Words> kWriteAFile = {
    run_with("--result"),
    run_with("--record"),
    run_with("--inspect"),
    run_with("--mcap"),
    run_with("--memory"),
    {"sim", "config/worlds/short.yaml", "--picture"},
    {"task", "show", "config/tasks/corridor.yaml", "--svg"},
    {"task", "show", "config/tasks/corridor.yaml", "--xml"},
    {"learn-descriptor", "--out"},
    {"calibrate", "data", "--out"},
    {"odometry", "data", "--out"},
    {"teach", "book", "--image", "data/pictures/plan.png", "--memory"},
    {"recall", "no.rec", "--picture"},
    {"export", "no.rec", "--mcap"},
    {"memory", "no.db", "export"},
    {"memory", "no.db", "map", "--picture"},
    {"memory", "no.db", "show", "book", "--picture"},
    {"ros", "run", "config/tasks/corridor.yaml", "--result"},
    {"ros", "serve", "--world", "config/worlds/short.yaml", "--memory"},
};

/// Those whose last word is the folder to write into.
const std::vector<Words> kWriteIntoAFolder = {
    run_with("--pictures"),
    {"trial", "--worlds", "config/worlds/short.yaml", "--out"},
    {"trial", "--objects", "--out"},
    {"trial", "merge", "data", "--out"},
    {"perceive", "--left", "data/pictures/plan.png", "--out"},
    {"replay", "no.rec", "--picture-every", "10", "--pictures"},
    {"ros", "replay", "no.bag", "--out"},
    {"eval", "stereo", "data", "--out"},
    {"eval", "patches", "data", "--out"},
    {"eval", "keypoints", "data", "--out"},
    {"eval", "saliency", "data", "--out"},
    {"eval", "objects", "data", "--out"},
    {"eval", "odometry", "data", "--out"},
    {"eval", "places", "data", "--out"},
};

TEST(Outputs, AFileThatCannotBeWrittenIsSaidBeforeAnyWork) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file.txt", "here first");
  std::filesystem::create_directories(folder / "folder.png");
  for (const Words& command : kWriteAFile) {
    expect_refused_there(command, "/proc/no/out.png");
    expect_refused_there(command, "/proc/out.png");
    expect_refused_there(command, file + "/out.png");
    expect_refused_there(command, folder / "folder.png");
  }
  EXPECT_EQ(read_text(file), "here first");
}

TEST(Outputs, AFolderThatCannotBeWrittenIntoIsSaidBeforeAnyWork) {
  const TemporaryFolder folder;
  const std::string file = folder.write("file.txt", "here first");
  for (const Words& command : kWriteIntoAFolder) {
    for (const std::string& bad : {std::string("/proc/no"), std::string("/proc"), file}) {
      expect_refused_there(command, bad);
    }
  }
}

TEST(Outputs, NothingIsWrittenOverWhatElseIsNamed) {
  const TemporaryFolder folder;
  const std::string task =
      folder.write("task.yaml", read_text(kRoot + "config/tasks/corridor.yaml"));
  const std::string world =
      folder.write("world.yaml", read_text(kRoot + "config/worlds/short.yaml"));
  const std::string out = folder / "out";
  expect_refused({
      {{"run", task, "--world", world, "--record", task}, "the task script and --record are the"},
      {{"run", task, "--world", world, "--record", out, "--result", out},
       "--record and --result are the same file"},
      {{"run", task, "--world", world, "--mcap", world}, "--world and --mcap are the same file"},
      {{"run", task, "--world", world, "--memory", out, "--inspect", folder / "./out"},
       "--memory and --inspect are"},
      {{"odometry", folder / "v.avi", "--calibration", task, "--out", task},
       "--calibration and --out are the same file"},
      {{"task", "show", task, "--svg", task}, "the task script and --svg are the same file"},
      {{"task", "show", task, "--svg", out, "--xml", out}, "--svg and --xml are the same file"},
  });
  EXPECT_EQ(read_text(task), read_text(kRoot + "config/tasks/corridor.yaml"));
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Outputs, AMissingFolderIsMade) {
  const TemporaryFolder folder;
  const std::string tree = folder / "new/and/new/tree.svg";
  EXPECT_EQ(striate_here({"task", "show", "config/tasks/corridor.yaml", "--svg", tree}).exit_code,
            0);
  EXPECT_THAT(read_text(tree), HasSubstr("<svg"));
}

/// "Done" is said of nothing that a full disk has swallowed.
TEST(Outputs, AFullDeviceIsNoSuccess) {
  for (const std::string words :
       {"task actions", "--help", "help run", "--version", "help --man", "config",
        "task actions --json", "check config/tasks/corridor.yaml"}) {
    const Ended ended = bash("\"$striate\" " + words + " > /dev/full");
    EXPECT_EQ(ended.exit_code, 1) << words;
    EXPECT_THAT(ended.err, HasSubstr("No space left on device")) << words;
  }
}

TEST(Outputs, ADeviceIsWrittenToAndNotReplaced) {
  const Ended full =
      striate_here({"task", "show", "config/tasks/corridor.yaml", "--svg", "/dev/full"});
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_THAT(full.err, HasSubstr("/dev/full: cannot be written: No space left on device"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
  EXPECT_EQ(
      striate_here({"task", "show", "config/tasks/corridor.yaml", "--svg", "/dev/null"}).exit_code,
      0);
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace striate::scenarios
