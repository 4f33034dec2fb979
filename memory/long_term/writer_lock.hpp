#pragma once

#include <string>

namespace striate::memory {

/// Only one session at a time writes into a memory. The lock is on FILE-lock beside it and goes
/// with the process, whatever ends it; the file itself stays and says who holds it.
class WriterLock {
 public:
  /// @param who what to tell others, e.g. "striate run".
  /// @throws UserError where another process holds it, naming that, or nothing can be written.
  WriterLock(const std::string& memory, const std::string& who);
  ~WriterLock();
  WriterLock(const WriterLock&) = delete;
  WriterLock& operator=(const WriterLock&) = delete;

 private:
  int descriptor_ = -1;
};

}  // namespace striate::memory
