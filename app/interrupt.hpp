#pragma once

namespace striate::app {

/// Ctrl-C and SIGTERM ask for a safe end: the mission halts, runs `finally`, writes its result.
/// A second Ctrl-C does what it always does.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] static bool requested();
};

}  // namespace striate::app
