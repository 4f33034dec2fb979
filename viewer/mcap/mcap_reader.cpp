#include "striate/viewer/mcap/mcap_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <utility>

#include "striate/base/crc32.hpp"
#include "striate/base/user_error.hpp"
#include "striate/viewer/mcap/compression.hpp"
#include "striate/viewer/mcap/record_bytes.hpp"

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

/// What is left of some content behind what a reader has taken from it.
ByteView rest_of(ByteView content, const ByteReader& reader) {
  return content.subspan(content.size() - reader.left());
}

}  // namespace

Reader::Reader(const std::string& file) : Reader(open_mcap(file), file) {}

Reader::Reader(std::unique_ptr<std::istream> stream, std::string name)
    : stream_(std::move(stream)), name_(std::move(name)) {
  stream_->seekg(0, std::ios::end);
  size_ = static_cast<std::uint64_t>(std::max<std::streamoff>(0, stream_->tellg()));
  read_head();
}

void Reader::read_head() {
  const auto begins_with_magic = [this] {
    return record_.size() == kMagic.size() &&
           std::equal(kMagic.begin(), kMagic.end(), record_.begin());
  };
  read_bytes(std::min<std::uint64_t>(size_, kMagic.size()));
  if (!begins_with_magic()) {
    throw UserError(fmt::format("{}: is no MCAP file: it does not begin as one", name_));
  }
  if (size_ >= 2 * kMagic.size()) {
    at_ = size_ - kMagic.size();
    read_bytes(kMagic.size());
    closed_ = begins_with_magic();
    if (closed_) size_ -= kMagic.size();
  }
  at_ = kMagic.size();
  data_crc_ = crc32(kMagic);
  Record head;
  if (!read_record(head)) damaged("it ends within its head");
  if (head.kind != Kind::header) damaged("it does not begin with its header");
  try {
    ByteReader reader(head.content);
    profile_ = reader.take_text();
    library_ = reader.take_text();
  } catch (const BadBytes& error) {
    damaged(error.what());
  }
}

/// Into `record_`, from `at_` on. There are as many: the size of the file is known.
void Reader::read_bytes(std::uint64_t count) {
  record_.resize(count);
  stream_->clear();
  stream_->seekg(static_cast<std::streamoff>(at_));
  stream_->read(reinterpret_cast<char*>(record_.data()), static_cast<std::streamsize>(count));
  if (static_cast<std::uint64_t>(stream_->gcount()) != count) {
    throw UserError(fmt::format("{}: cannot be read at byte {}", name_, at_));
  }
}

/// False where the file is cut off. In one that ends as a whole one does, that is damage.
bool Reader::read_record(Record& record) {
  record_at_ = at_;
  const auto is_cut_off = [this] {
    if (closed_) damaged("a record is longer than the file");
    return false;
  };
  if (size_ - at_ < kRecordHead_bytes) return is_cut_off();
  read_bytes(kRecordHead_bytes);
  const Bytes head = record_;
  ByteReader reader(head);
  record.kind = static_cast<Kind>(reader.u8());
  const auto length = reader.take<std::uint64_t>();
  if (length > size_ - at_ - kRecordHead_bytes) return is_cut_off();
  if (length > kMostRecord_bytes) damaged("a record is longer than any that is read (256 MB)");
  at_ += kRecordHead_bytes;
  read_bytes(length);
  at_ += length;
  record.content = record_;
  if (part_ == Part::data && record.kind != Kind::data_end) {
    data_crc_ = crc32(record_, crc32(head, data_crc_));
  } else if (part_ == Part::summary && record.kind != Kind::footer) {
    summary_crc_ = crc32(record_, crc32(head, summary_crc_));
  }
  return true;
}

bool Reader::next(Message& message) {
  try {
    while (ending_ == Ending::unread) {
      if (in_chunk_ < chunk_.size()) {
        if (next_in_chunk(message)) return true;
        continue;
      }
      Record record;
      if (!read_record(record)) {
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
    case Kind::metadata: {
      definitions_bytes_ += record.content.size();
      if (definitions_bytes_ > kMostDefinitions_bytes) throw BadBytes("there is too much metadata");
      ByteReader reader(record.content);
      const std::string name = reader.take_text();
      metadata_[name] = take_text_map(reader);
      ++counted_.metadata;
      return false;
    }
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
    if (is_new) definitions_bytes_ += record.content.size();
    if (definitions_bytes_ > kMostDefinitions_bytes) throw BadBytes("there are too many schemas");
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
  place.at = record_at_;
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
  const std::uint64_t behind = std::exchange(at_, attachment.at);
  const std::uint32_t crc = data_crc_;
  const std::uint32_t summary_crc = summary_crc_;
  Record record;
  ByteView data;
  try {
    if (!read_record(record) || record.kind != Kind::attachment) damaged("no attachment is there");
    (void)take_attachment(record.content, data);
  } catch (const BadBytes& error) {
    damaged(error.what());
  }
  at_ = behind;
  data_crc_ = crc;
  summary_crc_ = summary_crc;
  return {data.begin(), data.end()};
}

void Reader::take_data_end(ByteView content) {
  const std::uint32_t crc = ByteReader(content).u32();
  if (crc != 0 && crc != data_crc_) throw BadBytes("the checksum of all data is wrong");
  part_ = Part::summary;
  summary_at_ = at_;
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
    if (crc != crc32(ByteView(head).first(head.size() - 4), summary_crc_)) {
      throw BadBytes("the checksum of the summary is wrong");
    }
  }
  ending_ = closed_ ? Ending::closed : Ending::cut_off;
}

const Schema& Reader::schema_of(const Channel& channel) const {
  static const Schema kNone;
  const auto found = schemas_.find(channel.schema);
  return found == schemas_.end() ? kNone : found->second;
}

void Reader::damaged(const std::string& what) const {
  throw UserError(fmt::format("{}: is damaged at byte {}, after {} messages, which are good: {}",
                              name_, record_at_, counted_.messages, what));
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
