#include "striate/app/operator_reset.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <csignal>

namespace striate::app {
namespace {

volatile std::sig_atomic_t g_reset_asked = 0;

extern "C" void note_reset(int /*signal*/) {
  g_reset_asked = 1;
}

/// A program in the background that reads its terminal is stopped, and so would be the robot.
bool may_read_terminal() {
  return isatty(STDIN_FILENO) == 1 && tcgetpgrp(STDIN_FILENO) == getpgrp();
}

/// What was typed since, as far as a line is complete.
std::string typed_now() {
  std::string text;
  pollfd keys{STDIN_FILENO, POLLIN, 0};
  if (!may_read_terminal() || poll(&keys, 1, 0) != 1 || (keys.revents & POLLIN) == 0) return text;
  std::array<char, 64> bytes{};
  const ssize_t size = read(STDIN_FILENO, bytes.data(), bytes.size());
  if (size > 0) text.assign(bytes.data(), static_cast<std::size_t>(size));
  return text;
}

}  // namespace

OperatorReset::OperatorReset() {
  g_reset_asked = 0;
  struct sigaction asks {};
  asks.sa_handler = note_reset;
  asks.sa_flags = SA_RESTART;
  sigaction(SIGUSR1, &asks, &before_);
}

OperatorReset::~OperatorReset() {
  sigaction(SIGUSR1, &before_, nullptr);
}

bool OperatorReset::asked() {
  bool asked = g_reset_asked != 0;
  g_reset_asked = 0;
  typed_ += typed_now();
  for (std::size_t end = typed_.find('\n'); end != std::string::npos; end = typed_.find('\n')) {
    const std::string line = typed_.substr(0, end);
    asked = asked || line == "r" || line == "reset";
    typed_.erase(0, end + 1);
  }
  return asked;
}

std::string OperatorReset::hint() {
  const std::string signal = fmt::format("'kill -USR1 {}'", getpid());
  return isatty(STDIN_FILENO) == 1 ? "r and Enter, or " + signal : signal;
}

}  // namespace striate::app
