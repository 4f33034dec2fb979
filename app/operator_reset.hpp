#pragma once

#include <csignal>
#include <string>

namespace striate::app {

/// How a person lets a robot go on that holds until it is reset: the letter r and Enter at the
/// terminal, or the signal USR1. One at a time.
class OperatorReset {
 public:
  OperatorReset();
  ~OperatorReset();
  OperatorReset(const OperatorReset&) = delete;
  OperatorReset& operator=(const OperatorReset&) = delete;

  /// Whether it was asked for since the last call. Never waits.
  [[nodiscard]] bool asked();
  /// What to tell the person.
  [[nodiscard]] static std::string hint();

 private:
  std::string typed_;
  struct sigaction before_ {};
};

}  // namespace striate::app
