#pragma once

#include <string>

namespace striate {

/// A pseudo-terminal whose other end anybody may open.
class PseudoTerminal {
 public:
  /// @throws std::runtime_error when none is to be had.
  PseudoTerminal();
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;
  [[nodiscard]] int master() const { return master_; }  ///< its user closes it
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  int master_;
  int slave_ = -1;
  std::string name_;
};

}  // namespace striate
