#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "striate/base/user_error.hpp"
#include "striate/tasks/task_reader.hpp"

/// Each file of tests/broken_tasks is checked, and what is told of it must be what stands in the
/// .expected file beside it, to the letter: places, fault numbers, carets and suggestions.
namespace striate::tasks {
namespace {

namespace fs = std::filesystem;

std::string folder() {
  return std::string(STRIATE_SOURCE_DIR "/tests/broken_tasks/");
}

std::string content(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// What `striate check` tells, without the folder.
std::string told_of(const std::string& file) {
  std::string text;
  try {
    (void)check_task(file, RobotDescription{});
    return "good";
  } catch (const UserError& error) {
    text = error.what();
  }
  for (std::size_t at = text.find(folder()); at != std::string::npos; at = text.find(folder())) {
    text.erase(at, folder().size());
  }
  return text + "\n";
}

std::vector<fs::path> broken_files() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder())) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

TEST(BrokenTasks, AreToldWithEveryMistakeInOnePass) {
  const std::vector<fs::path> files = broken_files();
  EXPECT_GE(files.size(), 40U);
  for (const fs::path& file : files) {
    fs::path expected = file;
    expected.replace_extension(".expected");
    EXPECT_EQ(told_of(file.string()), content(expected)) << file;
  }
}

TEST(BrokenTasks, EveryDiagnosticHasANumberOfItsKindAndAPlace) {
  std::set<std::string> numbers;
  for (const fs::path& file : broken_files()) {
    std::istringstream text(told_of(file.string()));
    for (std::string line; std::getline(text, line);) {
      const std::size_t at = line.find(": error");
      if (at == std::string::npos) continue;
      EXPECT_EQ(line.substr(at, 9), ": error[T") << file << " " << line;
      EXPECT_NE(line.substr(at + 9, 3), "000") << file << " " << line;
      numbers.insert(line.substr(at + 8, 4));
    }
  }
  // All of config/fault.hpp and tasks/fault.hpp but the two that need more than one file.
  EXPECT_GE(numbers.size(), 23U) << testing::PrintToString(numbers);
}

TEST(BrokenTasks, ALandmarkThatTheMemoryDoesNotKnowIsToldWhenTheMemoryIsGiven) {
  const std::string file = testing::TempDir() + "landmarks.yaml";
  std::ofstream(file) << "striate: 1\nneeds: {landmarks: [bok, door]}\ndo:\n  - stop: {}\n";
  EXPECT_NO_THROW(check_task(file, RobotDescription{}));
  const KnownLandmarks known = {"book", "door"};
  try {
    (void)check_task(file, RobotDescription{}, &known);
    ADD_FAILURE() << "not told";
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(":2:21: error[T035]: the memory knows no landmark "
                                                 "'bok'"));
    EXPECT_THAT(error.what(), testing::HasSubstr("did you mean 'book'?"));
  }
}

TEST(BrokenTasks, AParameterMayBeOpenInACheckButNotInARun) {
  const std::string file = folder() + "parts/return.yaml";
  EXPECT_NO_THROW(check_task(file, RobotDescription{}));
  EXPECT_NO_THROW(load_task(file, RobotDescription{}, {{"speed", "0.3 m/s"}}));
  try {
    (void)load_task(file, RobotDescription{});
    ADD_FAILURE() << "not told";
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(),
                testing::HasSubstr("error[T027]: the task needs the parameter 'speed'"));
  }
}

TEST(BrokenTasks, FilesThatUseEachOtherALotAreLimited) {
  const std::string base = testing::TempDir() + "level";
  for (int level = 0; level < 7; ++level) {
    std::ofstream file(base + std::to_string(level) + ".yaml");
    file << "striate: 1\ndo:\n";
    for (int i = 0; i < 10; ++i) {
      file << (level == 6 ? "  - stop: {}\n"
                          : "  - use: level" + std::to_string(level + 1) + ".yaml\n");
    }
  }
  try {
    (void)check_task(base + "0.yaml", RobotDescription{});
    ADD_FAILURE() << "not told";
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("error[T032]: more than 5000 steps"));
  }
}

}  // namespace
}  // namespace striate::tasks
