#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/reference/temporary_folder.hpp"

/// Runs the command `striate` as a user would, in the source tree.
namespace striate::scenarios {

struct Ended {
  int exit_code = -1;
  std::string out;
  std::string err;
};

inline std::string read_text(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

using reference::TemporaryFolder;

inline const std::string kRoot = STRIATE_SOURCE_DIR "/";  ///< of the source tree

/// When a program is sent SIGINT; never, without either.
struct Interrupt {
  std::chrono::milliseconds after{};
  std::string once_it_says{};  ///< to its standard output; however long a busy machine takes for it
  std::string once_there_is{};  ///< a file that it makes
};

inline void interrupt(pid_t child, const Interrupt& when, const std::string& out_file) {
  if (when.after.count() == 0 && when.once_it_says.empty() && when.once_there_is.empty()) return;
  const auto is_time = [&] {
    return read_text(out_file).find(when.once_it_says) != std::string::npos &&
           (when.once_there_is.empty() || std::filesystem::exists(when.once_there_is));
  };
  for (int i = 0; i < 600 && !is_time(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  std::this_thread::sleep_for(when.after);
  kill(child, SIGINT);
}

/// What comes of it in a process of its own, in the source tree, with its outputs in files.
/// @param become what the process does; it must not return
template <typename Become>
Ended ended(const Become& become, const Interrupt& when = {}) {
  const TemporaryFolder folder;
  const std::string out_file = folder / "out";
  const std::string err_file = folder / "err";
  std::fflush(nullptr);  // else the copy of this process would write it, too
  const pid_t child = fork();
  if (child == 0) {
    if (chdir(STRIATE_SOURCE_DIR) != 0 || freopen(out_file.c_str(), "w", stdout) == nullptr ||
        freopen(err_file.c_str(), "w", stderr) == nullptr) {
      _exit(99);
    }
    become();
    _exit(98);
  }
  interrupt(child, when, out_file);
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, read_text(out_file), read_text(err_file)};
}

inline std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  return argv;
}

/// Runs a program in the source tree.
inline Ended run_program(std::vector<std::string> words, const Interrupt& when = {}) {
  const std::vector<char*> argv = pointers_to(words);
  return ended([&] { execv(argv[0], argv.data()); }, when);
}

inline Ended striate(const std::vector<std::string>& arguments, const Interrupt& when = {}) {
  std::vector<std::string> words = {STRIATE_BINARY};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return run_program(std::move(words), when);
}

/// Lines of bash, in which "$striate" is the command.
inline Ended bash(const std::string& script) {
  return run_program({"/bin/bash", "-c", "striate='" STRIATE_BINARY "'\n" + script});
}

}  // namespace striate::scenarios
