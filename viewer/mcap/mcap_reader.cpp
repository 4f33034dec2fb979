#include "striate/viewer/mcap/mcap_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <string_view>
#include <utility>

#include "striate/base/crc32.hpp"
#include "striate/base/user_error.hpp"
#include "striate/viewer/mcap/compression.hpp"
#include "striate/viewer/mcap/record_bytes.hpp"

namespace striate::viewer::mcap {
namespace {

/// What is left of some content behind what a reader has taken from it.
ByteView rest_of(ByteView content, const ByteReader& reader) {
  return content.subspan(content.size() - reader.left());
}

}  // namespace

Reader::Reader(const std::string& file) : records_(file) {
  read_head();
}

Reader::Reader(std::unique_ptr<std::istream> stream, std::string name)
    : records_(std::move(stream), std::move(name)) {
  read_head();
}

void Reader::read_head() {
  try {
    Record head;
    if (!records_.next(head)) throw BadBytes("it ends within its head");
    if (head.kind != Kind::header) throw BadBytes("it does not begin with its header");
    ByteReader reader(head.content);
    profile_ = reader.take_text();
    library_ = reader.take_text();
  } catch (const BadBytes& error) {
    damaged(error.what());
  }
}

bool Reader::next(Message& message) {
  try {
    while (ending_ == Ending::unread) {
      if (in_chunk_ < chunk_.size()) {
        if (next_in_chunk(message)) return true;
        continue;
      }
      Record record;
      if (!records_.next(record)) {
        ending_ = Ending::cut_off;
      } else if (part_ == Part::summary) {
        take_summary(record);
      } else if (take_data(record, message)) {
        return true;
      }
    }
  } catch (const BadBytes& error) {
    damaged(error.what());
  }
  return false;
}

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

/// @return whether it is a message by itself
bool Reader::take_data(const Record& record, Message& message) {
  switch (record.kind) {
    case Kind::schema:
    case Kind::channel:
      take_definition(record);
      return false;
    case Kind::message:
      take_message(record.content, message);
      return true;
    case Kind::chunk:
      open_chunk(record.content);
      return false;
    case Kind::attachment: {
      ByteView data;
      attachments_.push_back(take_attachment(record.content, data));
      ++counted_.attachments;
      return false;
    }
    case Kind::metadata:
      take_metadata(record.content);
      return false;
    case Kind::data_end:
      take_data_end(record.content);
      return false;
    case Kind::footer:
      throw BadBytes("its data do not end before its footer");
    default:
      return false;  // indices, and what later versions may add
  }
}

void Reader::take_definition(const Record& record) {
  const auto know = [this, &record](auto& known, auto found, const char* what) {
    const auto [place, is_new] = known.try_emplace(found.id, found);
    if (!is_new && place->second != found) {
      throw BadBytes(fmt::format("{} {} is defined twice, differently", what, found.id));
    }
    if (is_new) count_definitions(record.content.size());
    return is_new;
  };
  if (record.kind == Kind::schema) {
    if (know(schemas_, take_schema(record.content), "schema")) ++counted_.schemas;
    return;
  }
  Channel channel = take_channel(record.content);
  if (channel.schema != 0 && !schemas_.contains(channel.schema)) {
    throw BadBytes(fmt::format("channel {} has a schema that is not defined", channel.id));
  }
  if (know(channels_, std::move(channel), "channel")) ++counted_.channels;
}

void Reader::take_metadata(ByteView content) {
  count_definitions(content.size());
  ByteReader reader(content);
  const std::string name = reader.take_text();
  metadata_[name] = take_text_map(reader);
  ++counted_.metadata;
}

/// What is kept to the end of the file stays within bounds, whatever its chunks promise.
void Reader::count_definitions(std::size_t bytes) {
  definitions_bytes_ += bytes;
  if (definitions_bytes_ > kMostDefinitions_bytes) {
    throw BadBytes("its schemas, channels and metadata are more than is read (64 MB)");
  }
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

AttachmentPlace Reader::take_attachment(ByteView content, ByteView& data) const {
  ByteReader reader(content);
  AttachmentPlace place;
  (void)reader.take<std::uint64_t>();  // when it was logged and made
  (void)reader.take<std::uint64_t>();
  place.name = reader.take_text();
  place.media_type = reader.take_text();
  place.size = reader.take<std::uint64_t>();
  place.at = records_.at();
  if (reader.left() < 4 || place.size != reader.left() - 4) {
    throw BadBytes("an attachment has not the size that was promised");
  }
  data = rest_of(content, reader).first(place.size);
  const std::uint32_t crc = ByteReader(content.last(4)).u32();
  if (crc != 0 && crc != crc32(content.first(content.size() - 4))) {
    throw BadBytes(fmt::format("the checksum of the attachment '{}' is wrong", place.name));
  }
  return place;
}

Bytes Reader::read(const AttachmentPlace& attachment) {
  Record record;
  ByteView data;
  try {
    if (!records_.read_at(attachment.at, record) || record.kind != Kind::attachment) {
      throw BadBytes("no attachment is there");
    }
    (void)take_attachment(record.content, data);
  } catch (const BadBytes& error) {
    damaged(error.what());
  }
  return {data.begin(), data.end()};
}

void Reader::take_data_end(ByteView content) {
  const std::uint32_t crc = ByteReader(content).u32();
  if (crc != 0 && crc != records_.crc_before()) throw BadBytes("the checksum of all data is wrong");
  part_ = Part::summary;
  records_.begin_crc();
  summary_at_ = records_.behind();
}

void Reader::take_summary(const Record& record) {
  if (record.kind == Kind::footer) return take_footer(record.content);
  if (record.kind == Kind::schema || record.kind == Kind::channel) return take_definition(record);
  if (record.kind != Kind::statistics) return;
  const Statistics said = take_statistics(record.content);
  if (said.messages != counted_.messages || said.chunks != counted_.chunks ||
      said.attachments != counted_.attachments) {
    throw BadBytes(
        fmt::format("it should hold {} messages in {} chunks and {} attachments, and "
                    "holds {} in {} and {}",
                    said.messages, said.chunks, said.attachments, counted_.messages,
                    counted_.chunks, counted_.attachments));
  }
}

void Reader::take_footer(ByteView content) {
  ByteReader reader(content);
  const auto summary_at = reader.take<std::uint64_t>();
  (void)reader.take<std::uint64_t>();  // where the offsets begin: the summary was read through
  const std::uint32_t crc = reader.u32();
  if (summary_at != 0 && summary_at != summary_at_) {
    throw BadBytes("its footer names another place for the summary");
  }
  if (crc != 0) {
    Bytes head;
    append_record(head, Kind::footer, content);
    if (crc != crc32(ByteView(head).first(head.size() - 4), records_.crc_before())) {
      throw BadBytes("the checksum of the summary is wrong");
    }
  }
  ending_ = records_.closed() ? Ending::closed : Ending::cut_off;
}

const Schema& Reader::schema_of(const Channel& channel) const {
  static const Schema kNone;
  const auto found = schemas_.find(channel.schema);
  return found == schemas_.end() ? kNone : found->second;
}

void Reader::damaged(const std::string& what) const {
  throw UserError(fmt::format("{}: is damaged at byte {}, after {} messages, which are good: {}",
                              records_.name(), records_.at(), counted_.messages, what));
}

bool is_mcap(const std::string& file) {
  std::array<char, kMagic.size()> begin{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(begin.data(), begin.size());
  return stream.gcount() == static_cast<std::streamsize>(begin.size()) &&
         std::equal(kMagic.begin(), kMagic.end(), begin.begin(),
                    [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); });
}

}  // namespace striate::viewer::mcap
