#include "striate/viewer/mcap/record_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <utility>

#include "striate/base/crc32.hpp"
#include "striate/base/user_error.hpp"

namespace striate::viewer::mcap {
namespace {

std::unique_ptr<std::istream> open_mcap(const std::string& file) {
  std::error_code code;
  std::unique_ptr<std::ifstream> stream;
  // A pipe may never say anything, and a device never end.
  if (std::filesystem::is_regular_file(file, code)) {
    stream = std::make_unique<std::ifstream>(file, std::ios::binary);
  }
  if (!stream || !*stream) {
    throw UserError(fmt::format("{}: cannot be read\n    is the path right?", file));
  }
  return stream;
}

}  // namespace

RecordReader::RecordReader(const std::string& file) : RecordReader(open_mcap(file), file) {}

RecordReader::RecordReader(std::unique_ptr<std::istream> stream, std::string name)
    : stream_(std::move(stream)), name_(std::move(name)) {
  stream_->seekg(0, std::ios::end);
  size_ = static_cast<std::uint64_t>(std::max<std::streamoff>(0, stream_->tellg()));
  read_bytes(0, std::min<std::uint64_t>(size_, kMagic.size()));
  if (!has_magic()) {
    throw UserError(fmt::format("{}: is no MCAP file: it does not begin as one", name_));
  }
  next_at_ = kMagic.size();
  crc_ = crc32(kMagic);
  if (size_ < 2 * kMagic.size()) return;
  read_bytes(size_ - kMagic.size(), kMagic.size());
  closed_ = has_magic();
  if (closed_) size_ -= kMagic.size();
}

bool RecordReader::has_magic() const {
  return std::equal(kMagic.begin(), kMagic.end(), bytes_.begin(), bytes_.end());
}

void RecordReader::read_bytes(std::uint64_t at, std::uint64_t count) {
  bytes_.resize(count);
  stream_->clear();
  stream_->seekg(static_cast<std::streamoff>(at));
  stream_->read(reinterpret_cast<char*>(bytes_.data()), static_cast<std::streamsize>(count));
  if (static_cast<std::uint64_t>(stream_->gcount()) != count) {
    throw UserError(fmt::format("{}: cannot be read at byte {}", name_, at));
  }
}

bool RecordReader::next(Record& record) {
  record_at_ = next_at_;
  crc_before_ = crc_;
  const auto is_cut_off = [this] {
    if (closed_) throw BadBytes("a record is longer than the file");
    return false;
  };
  if (size_ - next_at_ < kRecordHead_bytes) return is_cut_off();
  read_bytes(next_at_, kRecordHead_bytes);
  crc_ = crc32(bytes_, crc_);
  ByteReader reader(bytes_);
  record.kind = static_cast<Kind>(reader.u8());
  const auto length = reader.take<std::uint64_t>();
  const std::uint64_t content_at = next_at_ + kRecordHead_bytes;
  if (length > size_ - content_at) return is_cut_off();
  if (length > kMostRecord_bytes)
    throw BadBytes("a record is longer than any that is read (256 MB)");
  read_bytes(content_at, length);
  crc_ = crc32(bytes_, crc_);
  next_at_ = content_at + length;
  record.content = bytes_;
  return true;
}

bool RecordReader::read_at(std::uint64_t place, Record& record) {
  const std::uint64_t behind = std::exchange(next_at_, place);
  const std::uint32_t crc = crc_;
  const bool there = next(record);
  next_at_ = behind;
  crc_ = crc;
  return there;
}

}  // namespace striate::viewer::mcap
