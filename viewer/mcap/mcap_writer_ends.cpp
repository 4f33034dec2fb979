#include "striate/viewer/mcap/mcap_writer.hpp"
#include "striate/viewer/mcap/record_bytes.hpp"

namespace striate::viewer::mcap {

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
