#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

namespace striate::app {

/// How a child process ended.
struct ProcessEnd {
  std::size_t job = 0;  ///< index into the list of commands
  int exit_code = -1;   ///< -1: ended by a signal
  std::string output;   ///< what it printed on standard error
};

/// Runs commands in `jobs` processes at once and hands each end to `on_end`, in the order in
/// which they end. Stops starting new ones, and asks the running ones to end, once
/// `cancelled` says so. A crash of one run cannot take the others with it; the death of this
/// process ends them all, as long as the thread that calls lives as long as the process.
/// @throws std::runtime_error when no process can be started.
void run_processes(const std::vector<std::vector<std::string>>& commands, int jobs,
                   const std::function<void(const ProcessEnd&)>& on_end,
                   const std::function<bool()>& cancelled);

}  // namespace striate::app
