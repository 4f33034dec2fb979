#include <fmt/format.h>

#include <algorithm>

#include "striate/base/crc32.hpp"
#include "striate/base/user_error.hpp"
#include "striate/viewer/mcap/compression.hpp"
#include "striate/viewer/mcap/mcap_reader.hpp"
#include "striate/viewer/mcap/record_bytes.hpp"

namespace striate::viewer::mcap {

/// One record of the chunk. @return whether it was a message
bool Reader::next_in_chunk(Message& message) {
  const ByteView rest = ByteView(chunk_).subspan(in_chunk_);
  ByteReader reader(rest);
  const auto kind = static_cast<Kind>(reader.u8());
  const auto length = reader.take<std::uint64_t>();
  if (length > reader.left()) throw BadBytes("a record is longer than its chunk");
  const Record record{kind, rest.subspan(kRecordHead_bytes, length)};
  in_chunk_ += kRecordHead_bytes + length;
  if (kind == Kind::message) {
    take_message(record.content, message);
    return true;
  }
  if (kind == Kind::schema || kind == Kind::channel) {
    take_definition(record);
  } else if (kind <= Kind::data_end) {
    throw BadBytes("a chunk holds what belongs outside");
  }
  return false;
}

void Reader::take_message(ByteView content, Message& message) {
  ByteReader reader(content);
  message.channel = reader.u16();
  message.sequence = reader.u32();
  message.log_time_ns = reader.take<std::uint64_t>();
  message.publish_time_ns = reader.take<std::uint64_t>();
  message.data = rest_of(content, reader);
  if (!channels_.contains(message.channel)) {
    throw BadBytes(
        fmt::format("a message is of channel {}, which is not defined", message.channel));
  }
  Statistics& all = counted_;
  const std::uint64_t time_ns = message.log_time_ns;
  all.begin_ns = all.messages == 0 ? time_ns : std::min(all.begin_ns, time_ns);
  all.end_ns = std::max(all.end_ns, time_ns);
  ++all.messages;
  ++all.messages_of_channel[message.channel];
}

void Reader::open_chunk(ByteView content) {
  ByteReader reader(content);
  (void)reader.take<std::uint64_t>();  // first and last time: the messages say it themselves
  (void)reader.take<std::uint64_t>();
  const auto size = reader.take<std::uint64_t>();
  const std::uint32_t crc = reader.u32();
  const std::string compression = reader.take_text();
  const auto compressed = reader.take<std::uint64_t>();
  if (size > kMostRecord_bytes) throw BadBytes("a chunk is larger than any that is read (256 MB)");
  if (compressed != reader.left()) throw BadBytes("a chunk has not the size that was promised");
  decompress(rest_of(content, reader), compression, size, chunk_);
  in_chunk_ = 0;
  if (crc != 0 && crc != crc32(chunk_)) {
    chunk_.clear();
    throw BadBytes("the checksum of a chunk is wrong");
  }
  ++counted_.chunks;
}

}  // namespace striate::viewer::mcap
