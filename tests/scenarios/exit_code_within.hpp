#pragma once

#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace striate::scenarios {

/// Waits for its end, killing it if that does not come. @return exit code; -1: it did not end
inline int exit_code_within(pid_t child, std::chrono::seconds patience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (std::chrono::steady_clock::now() > end) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      return -1;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace striate::scenarios
