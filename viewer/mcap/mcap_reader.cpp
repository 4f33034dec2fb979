#include "striate/viewer/mcap/mcap_reader.hpp"

#include <fmt/format.h>

#include <utility>

#include "striate/base/user_error.hpp"
#include "striate/viewer/mcap/compression.hpp"
#include "striate/viewer/mcap/record_bytes.hpp"

namespace striate::viewer::mcap {

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

const Schema& Reader::schema_of(const Channel& channel) const {
  static const Schema kNone;
  const auto found = schemas_.find(channel.schema);
  return found == schemas_.end() ? kNone : found->second;
}

void Reader::damaged(const std::string& what) const {
  throw UserError(fmt::format("{}: is damaged at byte {}, after {} messages, which are good: {}",
                              records_.name(), records_.at(), counted_.messages, what));
}

}  // namespace striate::viewer::mcap
