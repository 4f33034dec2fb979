#pragma once

#include <string>
#include <vector>

namespace striate::config {

/// A place in a configuration file; line and column count from 1, 0 means the file as a whole.
struct Place {
  int line = 0;
  int column = 0;
};

/// One mistake of the user's: what is wrong, where, and how to mend it.
struct Mistake {
  Place place;
  std::string message;  ///< e.g. "unknown key 'lenght'"
  std::string hint;     ///< e.g. "did you mean 'length'?"; may be empty
};

/// Collects every mistake of one file, so that all are told in one pass.
class Mistakes {
 public:
  explicit Mistakes(std::string file) : file_(std::move(file)) {}
  void add(Place place, std::string message, std::string hint = {});
  [[nodiscard]] bool none() const { return list_.empty(); }
  [[nodiscard]] const std::vector<Mistake>& list() const { return list_; }
  [[nodiscard]] const std::string& file() const { return file_; }
  void set_source(std::string text) { source_ = std::move(text); }

  /// All mistakes in the order of their places: `file:line:column: error: message`, the line
  /// itself with a caret, and the hint.
  [[nodiscard]] std::string text() const;

  /// Throws UserError with text() unless there are none.
  void throw_if_any() const;

 private:
  std::string file_;
  std::string source_;
  std::vector<Mistake> list_;
};

}  // namespace striate::config
