#pragma once

#include <string>

namespace striate::memory {

/// Only one session at a time writes into a memory. The lock is on the file itself, so it holds
/// whatever name leads to it: a link, a hard link, another path. It goes with the process, whatever
/// ends that. The file is made, empty, where there is none.
class WriterLock {
 public:
  /// @throws UserError where another process holds it, naming that, or nothing can be written.
  explicit WriterLock(const std::string& memory);
  /// Only after SQLite has closed the file: closing any descriptor of it ends SQLite's own locks.
  ~WriterLock();
  WriterLock(const WriterLock&) = delete;
  WriterLock& operator=(const WriterLock&) = delete;

 private:
  int descriptor_ = -1;
};

}  // namespace striate::memory
