#pragma once

#include <array>
#include <csignal>
#include <cstddef>

namespace striate::app {

/// While it lives, every signal that may end a program and can be caught asks for a safe end
/// instead: the mission halts, runs `finally`, brakes, writes its result and closes its session.
/// Ctrl-C, SIGTERM and SIGQUIT count: the second one insists, so that `finally` is left out; the
/// third one kills, and what holds the robot's line brakes it (platform/pioneer/keeper).
class Interrupt {
 public:
  /// What a write of our own does that finds no reader, or no room below the limit on file sizes.
  enum class BrokenOutput {
    is_an_error,  ///< of that write: who only reports must not end a drive
    ends,         ///< as it does without this: there is nothing to be ended safely
  };
  explicit Interrupt(BrokenOutput broken = BrokenOutput::is_an_error);
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] static bool requested();
  /// Somebody has asked twice, and does not want to wait for `finally`.
  [[nodiscard]] static bool insisted();

 private:
  /// Signals: more than end a program and can be caught (signal(7))
  static constexpr std::size_t kMostSignals = 16;
  struct Before {
    int signal = 0;
    struct sigaction action {};
  };
  void catch_signal(int signal, bool even_if_ignored);

  std::array<Before, kMostSignals> before_;
  std::size_t caught_ = 0;
};

}  // namespace striate::app
