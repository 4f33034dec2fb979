#include "tests/failing_calls/failing_calls.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/scenarios/striate_here.hpp"
#include "tests/scenarios/taught_memory.hpp"

/// Each command that writes into a memory, with each of its system calls that write failing in
/// turn: what is said to be done is on the disk, what was there before is there still.
/// STRIATE_FAILING_CALLS=1 lets every call fail, otherwise every 29th does.
namespace striate::failing_calls {
namespace {

using scenarios::Ended;
using scenarios::TemporaryFolder;
using Words = std::vector<std::string>;
namespace fs = std::filesystem;

struct Command {
  const char* name;
  Words words;  ///< FILE is the memory, FOLDER where other files are
};

const std::vector<Command> kCommands = {
    {"teach", {"teach", "vase", "--image", "FOLDER/thing_9.png", "--memory", "FILE"}},
    {"teach_anew", {"teach", "vase", "--image", "FOLDER/thing_9.png", "--memory", "NEW"}},
    {"undo", {"teach", "--undo", "--memory", "FILE"}},
    {"rename", {"memory", "FILE", "rename", "cup", "mug"}},
    {"forget", {"memory", "FILE", "forget", "cup"}},
    {"restore", {"memory", "FILE", "restore", "plate"}},
    {"merge", {"memory", "FILE", "merge", "FOLDER/other.db"}},
    {"import", {"memory", "FILE", "import", "FOLDER/other.json"}},
    {"prune", {"memory", "FILE", "prune", "--yes", "--robot", "FOLDER/r.yaml"}},
    {"export", {"memory", "FILE", "export", "OUT"}},
};

class FailingCalls : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"cup", "plate", "jug"}) {
      scenarios::teach(begin_, name, scenarios::image_of_a_thing(folder_, ++things_));
    }
    ASSERT_EQ(scenarios::memory(begin_, {"forget", "plate"}).exit_code, 0);
    const std::string other = folder_ / "other.db";
    scenarios::teach(other, "bowl", scenarios::image_of_a_thing(folder_, ++things_));
    ASSERT_EQ(scenarios::memory(other, {"export", folder_ / "other.json"}).exit_code, 0);
    (void)scenarios::image_of_a_thing(folder_, 9);
    (void)folder_.write("r.yaml", "long_term_memory: {most_episodes: 1}\n");
  }

  [[nodiscard]] std::string disk() const { return folder_ / "disk"; }
  [[nodiscard]] std::string file() const { return folder_ / "disk/home.db"; }

  void begin() const {
    fs::remove_all(disk());
    fs::create_directory(disk());
    for (const char* part : {"", "-wal", "-shm"}) {
      if (fs::exists(begin_ + part)) fs::copy_file(begin_ + part, file() + part);
    }
  }

  [[nodiscard]] Words filled_in(const Command& command) const {
    Words words;
    for (const std::string& word : command.words) {
      std::string text = word;
      const auto put = [&](const std::string& key, const std::string& value) {
        if (text.rfind(key, 0) == 0) text = value + text.substr(key.size());
      };
      put("FILE", file());
      put("NEW", folder_ / "disk/new.db");
      put("OUT", folder_ / "disk/out.json");
      put("FOLDER", folder_.path());
      words.push_back(text);
    }
    return words;
  }

  /// The command, with a call that fails. @param calls how many there were
  Ended run(const Command& command, long number, int error, bool keeps, long& calls) const {
    std::vector<std::string> words = filled_in(command);
    words.insert(words.begin(), "striate");
    const std::string counted = folder_ / "count";
    std::vector<char*> argv = scenarios::pointers_to(words);
    const Ended ended = scenarios::ended([&] {
      arm(disk(), number, error, keeps);
      const int code = app::run_program(static_cast<int>(words.size()), argv.data());
      const long made = count();
      arm("", 0, 0, false);
      std::fflush(nullptr);
      std::ofstream(counted) << made << std::flush;
      _exit(code);
    });
    std::ifstream(counted) >> calls;
    return ended;
  }

  /// What is in the memories on the disk, without times and numbers.
  [[nodiscard]] std::string state() const {
    std::string text;
    for (const char* name : {"home.db", "new.db"}) {
      const std::string memory = folder_ / ("disk/" + std::string(name));
      if (!fs::exists(memory)) continue;
      const Ended checked = scenarios::memory(memory, {"check"});
      if (checked.err.find("empty, not a memory yet") != std::string::npos) continue;
      EXPECT_EQ(checked.exit_code, 0) << checked.out << checked.err;
      std::string kept;
      for (const auto& one : scenarios::memory_json(memory, {"list", "--all"})) {
        kept += " " + one.at("name").dump() + one.at("views").dump() + one.at("keypoints").dump() +
                (one.at("retired_s").is_null() ? "" : "retired") + one.at("pinned").dump();
      }
      for (const auto& one : scenarios::memory_json(memory, {"episodes"})) {
        kept +=
            " " + one.at("kind").get<std::string>() + " " + one.at("landmark").get<std::string>();
      }
      // One that was made and has nothing in it yet is as good as none.
      if (!kept.empty()) text += name + kept + "\n";
    }
    return text;
  }

  /// An exported file is whole or not there.
  [[nodiscard]] bool exported() const {
    const std::string out = folder_ / "disk/out.json";
    if (!fs::exists(out)) return false;
    const auto json = nlohmann::json::parse(scenarios::read_text(out), nullptr, false);
    EXPECT_FALSE(json.is_discarded());
    return true;
  }

  TemporaryFolder folder_;
  std::string begin_ = folder_ / "begin.db";
  int things_ = 0;
};

TEST_F(FailingCalls, WhatIsSaidToBeDoneIsDoneAndNothingElseIsLost) {
  const long step = std::getenv("STRIATE_FAILING_CALLS") != nullptr ? 1 : 29;
  long failed = 0;
  for (const Command& command : kCommands) {
    begin();
    const std::string before = state();
    long calls = 0;
    const Ended good = run(command, 0, 0, false, calls);
    ASSERT_EQ(good.exit_code, 0) << command.name << good.err;
    ASSERT_GT(calls, 1) << command.name;
    const std::string after = state();
    const bool exports = exported();
    long number = 1 + static_cast<long>(command.name[0]) % step;
    for (; number <= calls; number += step) {
      for (const auto& [error, keeps] :
           {std::pair{ENOSPC, true}, {ENOSPC, false}, {EIO, true}, {EIO, false}}) {
        SCOPED_TRACE(testing::Message() << command.name << ", call " << number << " of " << calls
                                        << (keeps ? " and all after" : "") << " fails with "
                                        << (error == EIO ? "EIO" : "ENOSPC"));
        begin();
        long made = 0;
        const Ended ended = run(command, number, error, keeps, made);
        ++failed;
        const std::string now = state();
        EXPECT_GE(ended.exit_code, 0) << "it crashed: " << ended.err;
        if (ended.exit_code == 0) {
          EXPECT_EQ(now, after) << ended.out << ended.err;
          EXPECT_EQ(exported(), exports);
        } else {
          EXPECT_TRUE(now == before || now == after) << now << "\n" << before << "\n" << after;
          EXPECT_EQ(ended.out.find("done"), std::string::npos) << ended.out << ended.err;
          EXPECT_FALSE(ended.err.empty());
          (void)exported();
        }
        EXPECT_FALSE(fs::exists(folder_ / "disk/out.json.part"));
        if (HasFailure()) return;
      }
    }
  }
  RecordProperty("failed_calls", std::to_string(failed));
  std::printf("%ld system calls failed\n", failed);
}

}  // namespace
}  // namespace striate::failing_calls
