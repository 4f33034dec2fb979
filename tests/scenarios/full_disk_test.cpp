#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/scenarios/taught_memory.hpp"

namespace striate::scenarios {
namespace {

using testing::HasSubstr;

/// While this lives, a folder is a disk with little room for every program that is started; see
/// small_disk/small_disk.cpp.
class SmallDisk {
 public:
  SmallDisk(const std::string& folder, int bytes) {
    setenv("SMALL_DISK", std::filesystem::canonical(folder).c_str(), 1);
    setenv("SMALL_DISK_BYTES", std::to_string(bytes).c_str(), 1);
    setenv("LD_PRELOAD", STRIATE_SMALL_DISK, 1);
    // The address sanitizer wants to be the first library.
    const char* given = std::getenv("ASAN_OPTIONS");
    const std::string before = given != nullptr ? std::string(given) + ":" : "";
    setenv("ASAN_OPTIONS", (before + "verify_asan_link_order=0").c_str(), 1);
  }
  ~SmallDisk() {
    for (const char* name : {"SMALL_DISK", "SMALL_DISK_BYTES", "LD_PRELOAD"}) unsetenv(name);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
};

TEST(MemoryCommand, AFullDiskIsSaidAndWhatWasTaughtBeforeIsThere) {
  const TemporaryFolder folder;
  const std::string disk = folder / "disk";
  std::filesystem::create_directory(disk);
  const SmallDisk small(disk, 1 << 20);
  const std::string file = disk + "/home.db";
  int kept = 0;
  Ended last;
  for (int seed = 1; seed < 12; ++seed) {
    last = striate({"teach", "thing " + std::to_string(seed), "--image",
                    image_of_a_thing(folder, seed), "--memory", file});
    if (last.exit_code != 0) break;
    ++kept;
  }
  EXPECT_EQ(last.exit_code, 2);
  EXPECT_THAT(last.err, HasSubstr("home.db: error"));
  EXPECT_EQ(memory_json(file, {"list"}).size(), static_cast<std::size_t>(kept));
  EXPECT_EQ(memory(file, {"check"}).exit_code, 0);
  const Ended run = striate({"run", "config/tasks/corridor.yaml", "--world",
                             "config/worlds/empty.yaml", "--memory", file});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("there is no room left"));
}

TEST(MemoryCommand, PruneSaysDoneOnlyOnceItIsOnTheDisk) {
  const TemporaryFolder folder;
  const std::string disk = folder / "disk";
  std::filesystem::create_directory(disk);
  const std::string file = disk + "/home.db";
  const std::string robot = folder.write("r.yaml", "long_term_memory: {most_episodes: 1}\n");
  for (int seed = 1; seed < 4; ++seed) {
    teach(file, "thing " + std::to_string(seed), image_of_a_thing(folder, seed));
  }
  const std::size_t episodes = memory_json(file, {"episodes"}).size();
  ASSERT_GT(episodes, 1U);
  {
    // Room for SQLite's index of the log, not for what the commit writes.
    const SmallDisk full(disk, static_cast<int>(std::filesystem::file_size(file)) + 34000);
    const Ended ended = memory(file, {"prune", "--yes", "--robot", robot});
    EXPECT_EQ(ended.exit_code, 2);
    EXPECT_EQ(ended.out, "");
    EXPECT_THAT(ended.err, HasSubstr("there is no room left"));
  }
  EXPECT_EQ(memory_json(file, {"episodes"}).size(), episodes);
  EXPECT_THAT(memory(file, {"prune", "--yes", "--robot", robot}).out, HasSubstr("done\n"));
  EXPECT_EQ(memory_json(file, {"episodes"}).size(), 1U);
}

}  // namespace
}  // namespace striate::scenarios
