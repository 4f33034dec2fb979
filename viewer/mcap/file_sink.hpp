#pragma once

#include <cstdint>
#include <string>

#include "striate/base/bytes.hpp"

namespace striate::viewer::mcap {

/// A file that grows by whole pieces: what could be written of a piece only in part is cut off
/// again.
class FileSink {
 public:
  /// Makes the file, or empties it. @throws UserError where it cannot be written
  explicit FileSink(std::string file);
  ~FileSink();
  FileSink(const FileSink&) = delete;
  FileSink& operator=(const FileSink&) = delete;

  /// @throws std::runtime_error saying why it cannot be written on; a limit on file sizes (ulimit)
  /// is such a reason, and ends the program no more where this thread has written once
  void write(ByteView piece);
  /// @throws std::runtime_error: some disks say only now that they are full
  void close();
  [[nodiscard]] std::uint64_t bytes() const { return bytes_; }
  [[nodiscard]] const std::string& file() const { return file_; }

 private:
  std::string file_;
  int descriptor_ = -1;
  std::uint64_t bytes_ = 0;
};

}  // namespace striate::viewer::mcap
