#pragma once

#include <string>
#include <vector>

#include "striate/config/fault.hpp"

namespace striate::config {

/// A place in a configuration file; line and column count from 1, 0 means the file as a whole.
struct SourceLocation {
  int line = 0;
  int column = 0;
  bool operator==(const SourceLocation& other) const {
    return line == other.line && column == other.column;
  }
};

/// One mistake of the user's: what is wrong, where, and how to mend it.
struct Diagnostic {
  SourceLocation place;
  std::string message;  ///< e.g. "unknown key 'lenght'"
  std::string hint;     ///< e.g. "did you mean 'length'?"; may be empty
  Fault fault;
};

/// Collects every mistake of one file, so that all are told in one pass.
class Diagnostics {
 public:
  /// @param letter of the fault numbers: 'T' shows them as error[T014]; 0 shows none.
  explicit Diagnostics(std::string file, char letter = 0)
      : file_(std::move(file)), letter_(letter) {}
  void add(SourceLocation place, std::string message, std::string hint = {}) {
    add(fault::other, place, std::move(message), std::move(hint));
  }
  void add(Fault fault, SourceLocation place, std::string message, std::string hint = {});
  /// Takes in what is wrong with a file that this one uses; the same text is told once.
  void include(const Diagnostics& of_used_file);
  /// Takes out the mistakes at that place, for who tells them elsewhere.
  [[nodiscard]] std::vector<Diagnostic> take_at(SourceLocation place);
  /// Says under every mistake at that place where its value comes from.
  void note(SourceLocation place, std::string text) { notes_.push_back({place, std::move(text)}); }
  /// Something that is no mistake but should be changed; for the caller to print.
  void warn(SourceLocation place, std::string message, std::string hint = {}) {
    warnings_.push_back({place, std::move(message), std::move(hint), fault::other});
  }
  /// All warnings as in text(): `file:line:column: warning: message`; "" where there are none.
  [[nodiscard]] std::string warnings() const;
  /// All of this file and of those that it uses.
  [[nodiscard]] std::size_t count() const { return list_.size() + included_count_; }
  [[nodiscard]] bool none() const { return count() == 0; }
  [[nodiscard]] const std::vector<Diagnostic>& list() const { return list_; }
  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] char letter() const { return letter_; }
  void set_source(std::string text) { source_ = std::move(text); }

  /// All mistakes in the order of their places: `file:line:column: error: message`, the line
  /// itself with a caret, and the hint; then those of the files that it uses.
  [[nodiscard]] std::string text() const;

  /// Throws UserError with text() unless there are none.
  void throw_if_any() const;

 private:
  struct Note {
    SourceLocation place;
    std::string text;
  };
  [[nodiscard]] std::string text_of(const Diagnostic& diagnostic) const;
  [[nodiscard]] std::string told(const Diagnostic& diagnostic, const std::string& kind) const;

  std::string file_;
  char letter_ = 0;
  std::string source_;
  std::vector<Diagnostic> list_;
  std::vector<Diagnostic> warnings_;
  std::vector<Note> notes_;
  std::vector<std::string> included_;
  std::size_t included_count_ = 0;
};

}  // namespace striate::config
