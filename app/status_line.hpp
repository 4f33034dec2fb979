#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace striate::app {

/// The live line of a mission on standard error: rewritten in place on a terminal, a plain line
/// every ten seconds elsewhere, nothing when quiet. Never fails and never waits: what cannot be
/// shown is left out.
class StatusLine {
 public:
  explicit StatusLine(bool quiet);
  ~StatusLine();
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  /// Whether showing now would be seen: build the text only then.
  [[nodiscard]] bool due() const;
  void show(const std::string& text);
  /// How many characters are seen of a shown text.
  [[nodiscard]] std::size_t columns() const;
  /// A line of its own that stays.
  void tell(const std::string& text);
  /// Removes the line from a terminal, so that other output starts clean.
  void clear();
  /// Something could not be written.
  [[nodiscard]] bool failed() const { return failed_; }

 private:
  void put(std::string_view text) noexcept;

  using WallClock = std::chrono::steady_clock;
  bool quiet_;
  bool terminal_;
  bool shown_ = false;
  bool failed_ = false;
  WallClock::time_point last_;
};

}  // namespace striate::app
