#pragma once

#include <cstdlib>

#include "striate/app/program.hpp"
#include "tests/scenarios/striate_process.hpp"

namespace striate::scenarios {

/// The command in a copy of this process. Nothing is loaded for it, which takes half a second and
/// so longer than most commands that refuse or look something up. For those that start no program
/// and look for nothing beside their own, and where this process has one thread.
inline Ended striate_here(const std::vector<std::string>& arguments) {
  // What is to be loaded before the program needs one that is loaded.
  if (std::getenv("LD_PRELOAD") != nullptr) return striate(arguments);
  std::vector<std::string> words = {STRIATE_BINARY};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv = pointers_to(words);
  return ended([&] {
    const int code = app::run_program(static_cast<int>(words.size()), argv.data());
    std::fflush(nullptr);
    _exit(code);
  });
}

}  // namespace striate::scenarios
