#pragma once

#include <cstdint>
#include <istream>
#include <memory>
#include <string>

#include "striate/viewer/mcap/mcap_format.hpp"

namespace striate::viewer::mcap {

/// A record of a file or of a chunk.
struct Record {
  Kind kind{};
  ByteView content;
};

/// Takes an MCAP file apart into its records, and knows where it is. What the records mean is not
/// its business.
class RecordReader {
 public:
  /// @throws UserError where the file cannot be read or does not begin as an MCAP file
  explicit RecordReader(const std::string& file);
  /// The same from any stream that can be sought in; `name` is for messages.
  RecordReader(std::unique_ptr<std::istream> stream, std::string name);

  /// The next record; its content holds until the one after it. False where the file is cut off.
  /// @throws BadBytes for a length that cannot be: in a file that ends as a whole one does, that is
  /// one beyond its end, too. @throws UserError where the disk gives nothing
  bool next(Record& record);
  /// The record at a place that `at()` has told; the next one stays the next one.
  bool read_at(std::uint64_t place, Record& record);

  /// Byte of the file at which the record in hand begins.
  [[nodiscard]] std::uint64_t at() const { return record_at_; }
  /// Byte behind it.
  [[nodiscard]] std::uint64_t behind() const { return next_at_; }
  /// Whether the file ends as a whole one does.
  [[nodiscard]] bool closed() const { return closed_; }
  /// Checksum from the beginning, or from where it was begun anew, to the record in hand.
  [[nodiscard]] std::uint32_t crc_before() const { return crc_before_; }
  /// Begins it anew behind the record in hand.
  void begin_crc() { crc_ = 0; }
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  void read_bytes(std::uint64_t at, std::uint64_t count);
  [[nodiscard]] bool has_magic() const;

  std::unique_ptr<std::istream> stream_;
  std::string name_;
  std::uint64_t size_ = 0;  ///< of the file, without its last magic
  std::uint64_t next_at_ = 0;
  std::uint64_t record_at_ = 0;
  bool closed_ = false;
  std::uint32_t crc_ = 0;
  std::uint32_t crc_before_ = 0;
  Bytes bytes_;  ///< of the record in hand
};

}  // namespace striate::viewer::mcap
