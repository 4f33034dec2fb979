#pragma once

#include <chrono>
#include <string>

namespace striate::app {

/// The live line of a mission on standard error: rewritten in place on a terminal, a plain line
/// every ten seconds elsewhere, nothing when quiet.
class StatusLine {
 public:
  explicit StatusLine(bool quiet);
  ~StatusLine();
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  /// Whether showing now would be seen: build the text only then.
  [[nodiscard]] bool due() const;
  void show(const std::string& text);
  /// A line of its own that stays.
  void tell(const std::string& text);
  /// Removes the line from a terminal, so that other output starts clean.
  void clear();

 private:
  using WallClock = std::chrono::steady_clock;
  bool quiet_;
  bool terminal_;
  bool shown_ = false;
  WallClock::time_point last_;
};

}  // namespace striate::app
