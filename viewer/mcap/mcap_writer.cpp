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

void Writer::attach(const Attachment& attachment) {
  end_chunk();
  content_.clear();
  ByteWriter content(content_);
  content.put(attachment.log_time_ns);
  content.put(attachment.create_time_ns);
  content.put_text(attachment.name);
  content.put_text(attachment.media_type);
  content.put(static_cast<std::uint64_t>(attachment.data.size()));
  append(content_, attachment.data);
  content.put(checksum(content_));
  Bytes piece;
  append_record(piece, Kind::attachment, content_);

  Bytes bytes;
  ByteWriter index(bytes);
  index.put(written_);
  index.put(static_cast<std::uint64_t>(piece.size()));
  index.put(attachment.log_time_ns);
  index.put(attachment.create_time_ns);
  index.put(static_cast<std::uint64_t>(attachment.data.size()));
  index.put_text(attachment.name);
  index.put_text(attachment.media_type);
  append_record(attachment_indices_, Kind::attachment_index, bytes);
  send(piece);
  ++statistics_.attachments;
}

void Writer::add_metadata(const std::string& name, const TextMap& metadata) {
  end_chunk();
  content_.clear();
  ByteWriter content(content_);
  content.put_text(name);
  put_map(content_, metadata);
  Bytes piece;
  append_record(piece, Kind::metadata, content_);

  Bytes bytes;
  ByteWriter index(bytes);
  index.put(written_);
  index.put(static_cast<std::uint64_t>(piece.size()));
  index.put_text(name);
  append_record(metadata_indices_, Kind::metadata_index, bytes);
  send(piece);
  ++statistics_.metadata;
}

/// The groups of the summary, and for each the record that says where it is.
void Writer::append_summary(Bytes& piece, Bytes& offsets) const {
  Bytes content;
  std::size_t begin = piece.size();
  const std::uint64_t before = written_;
  const auto end_group = [&](Kind kind) {
    if (piece.size() == begin) return;
    content.clear();
    ByteWriter writer(content);
    writer.put(static_cast<std::uint8_t>(kind));
    writer.put(before + begin);
    writer.put(static_cast<std::uint64_t>(piece.size() - begin));
    append_record(offsets, Kind::summary_offset, content);
    begin = piece.size();
  };
  for (const Schema& schema : schemas_) append_record(piece, schema, content);
  end_group(Kind::schema);
  for (const Channel& channel : channels_) append_record(piece, channel, content);
  end_group(Kind::channel);
  append_record(piece, statistics_, content);
  end_group(Kind::statistics);
  for (const ChunkIndex& chunk : chunks_) {
    content.clear();
    ByteWriter writer(content);
    writer.put(chunk.begin_ns);
    writer.put(chunk.end_ns);
    writer.put(chunk.at);
    writer.put(chunk.length);
    put_map(content, chunk.message_index_at);
    writer.put(chunk.message_index_length);
    writer.put_text(name_in_file(options_.compression));
    writer.put(chunk.compressed);
    writer.put(chunk.uncompressed);
    append_record(piece, Kind::chunk_index, content);
  }
  end_group(Kind::chunk_index);
  append(piece, attachment_indices_);
  end_group(Kind::attachment_index);
  append(piece, metadata_indices_);
  end_group(Kind::metadata_index);
}

void Writer::close() {
  end_chunk();
  content_.clear();
  ByteWriter(content_).put(data_crc_);
  Bytes piece;
  append_record(piece, Kind::data_end, content_);
  const std::size_t summary_at = piece.size();
  Bytes offsets;
  append_summary(piece, offsets);
  const std::uint64_t offsets_at = written_ + piece.size();
  append(piece, offsets);

  ByteWriter footer(piece);
  footer.put(static_cast<std::uint8_t>(Kind::footer));
  footer.put(std::uint64_t{kFooter_bytes});
  footer.put(written_ + summary_at);
  footer.put(offsets_at);
  footer.put(checksum(ByteView(piece).subspan(summary_at)));
  append(piece, kMagic);
  send(piece);
}

}  // namespace striate::viewer::mcap
