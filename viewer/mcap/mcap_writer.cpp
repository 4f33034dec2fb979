#include "striate/viewer/mcap/mcap_writer.hpp"

#include <algorithm>

#include "striate/base/crc32.hpp"
#include "striate/viewer/mcap/record_bytes.hpp"

namespace striate::viewer::mcap {

Writer::Writer(Sink sink, WriterOptions options)
    : sink_(std::move(sink)), options_(std::move(options)) {
  Bytes head(kMagic.begin(), kMagic.end());
  ByteWriter content(content_);
  content.put_text(options_.profile);
  content.put_text(options_.library);
  append_record(head, Kind::header, content_);
  send(head);
}

void Writer::send(ByteView piece) {
  sink_(piece);
  written_ += piece.size();
  if (options_.checksums) data_crc_ = crc32(piece, data_crc_);
}

std::uint32_t Writer::checksum(ByteView bytes) const {
  return options_.checksums ? crc32(bytes) : 0;
}

std::uint16_t Writer::add_schema(const std::string& name, const std::string& encoding,
                                 const std::string& text) {
  const auto id = static_cast<std::uint16_t>(schemas_.size() + 1);
  schemas_.push_back({id, name, encoding, text});
  schema_is_defined_.push_back(false);
  ++statistics_.schemas;
  return id;
}

std::uint16_t Writer::add_channel(std::uint16_t schema, const std::string& topic,
                                  const std::string& message_encoding) {
  const auto id = static_cast<std::uint16_t>(channels_.size());
  channels_.push_back({id, schema, topic, message_encoding, {}});
  channel_is_defined_.push_back(false);
  sequence_.push_back(0);
  ++statistics_.channels;
  return id;
}

/// Into the chunk, before the first message: so what is cut off behind it can be understood.
void Writer::define(std::uint16_t channel) {
  if (channel_is_defined_[channel]) return;
  channel_is_defined_[channel] = true;
  const std::uint16_t schema = channels_[channel].schema;
  if (schema > 0 && !schema_is_defined_[schema - 1U]) {
    schema_is_defined_[schema - 1U] = true;
    append_record(chunk_, schemas_[schema - 1U], content_);
  }
  append_record(chunk_, channels_[channel], content_);
}

void Writer::write(std::uint16_t channel, std::uint64_t log_time_ns, ByteView message) {
  define(channel);
  if (chunk_messages_.empty()) chunk_begin_ns_ = chunk_end_ns_ = log_time_ns;
  chunk_begin_ns_ = std::min(chunk_begin_ns_, log_time_ns);
  chunk_end_ns_ = std::max(chunk_end_ns_, log_time_ns);
  chunk_messages_[channel].emplace_back(log_time_ns, chunk_.size());

  ByteWriter writer(chunk_);
  writer.put(static_cast<std::uint8_t>(Kind::message));
  writer.put(std::uint64_t{2 + 4 + 8 + 8} + message.size());
  writer.put(channel);
  writer.put(sequence_[channel]++);
  writer.put(log_time_ns);
  writer.put(log_time_ns);  // published when it was made
  append(chunk_, message);

  Statistics& all = statistics_;
  all.begin_ns = all.messages == 0 ? log_time_ns : std::min(all.begin_ns, log_time_ns);
  all.end_ns = std::max(all.end_ns, log_time_ns);
  ++all.messages;
  ++all.messages_of_channel[channel];
  if (chunk_.size() >= options_.chunk_bytes) end_chunk();
}

void Writer::end_chunk() {
  if (chunk_.empty()) return;
  const Bytes smaller = compress(chunk_, options_.compression);
  content_.clear();
  ByteWriter content(content_);
  content.put(chunk_begin_ns_);
  content.put(chunk_end_ns_);
  content.put(static_cast<std::uint64_t>(chunk_.size()));
  content.put(checksum(chunk_));
  content.put_text(name_in_file(options_.compression));
  content.put(static_cast<std::uint64_t>(smaller.size()));
  append(content_, smaller);
  Bytes piece;
  append_record(piece, Kind::chunk, content_);

  ChunkIndex index{chunk_begin_ns_, chunk_end_ns_, written_, piece.size(), {}, 0,
                   smaller.size(),  chunk_.size()};
  append_message_indices(piece, piece.size(), index);
  chunk_.clear();
  chunk_messages_.clear();
  send(piece);
  chunks_.push_back(std::move(index));
  ++statistics_.chunks;
}

void Writer::append_message_indices(Bytes& piece, std::size_t chunk_length,
                                    ChunkIndex& index) const {
  Bytes bytes;
  for (const auto& [channel, messages] : chunk_messages_) {
    index.message_index_at[channel] = written_ + piece.size();
    bytes.clear();
    ByteWriter content(bytes);
    content.put(channel);
    content.put(static_cast<std::uint32_t>(16 * messages.size()));
    for (const auto& [time_ns, offset] : messages) {
      content.put(time_ns);
      content.put(offset);
    }
    append_record(piece, Kind::message_index, bytes);
  }
  index.message_index_length = piece.size() - chunk_length;
}

}  // namespace striate::viewer::mcap
