#pragma once

#include <exception>
#include <string>
#include <vector>

namespace striate::app {

/// Whoever only reports a mission: recording, pictures, status line, memory. What fails there is
/// kept to be said once in the end; it never reaches the mission.
class Reports {
 public:
  /// Does it, unless it has failed before. @param what failed, for the message; must live as long.
  template <class Report>
  void attempt(const char* what, Report&& report) noexcept {
    if (!has_failed(what)) finish(what, report);
  }
  /// Does it in any case: files are closed though something was lost.
  template <class Report>
  void finish(const char* what, Report&& report) noexcept {
    try {
      report();
    } catch (const std::exception& error) {
      note(what, error.what());
    } catch (...) {
      note(what, "an unknown error");
    }
  }
  /// @param why "" where nothing was lost
  void note(const char* what, const char* why) noexcept;

  [[nodiscard]] bool has_failed(const char* what) const noexcept;
  [[nodiscard]] bool any_failed() const noexcept { return !failures_.empty(); }
  /// A line for each that failed.
  [[nodiscard]] std::string text() const;

 private:
  struct Failure {
    const char* what;
    std::string why;
  };
  std::vector<Failure> failures_;
};

}  // namespace striate::app
