#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "striate/viewer/mcap/compression.hpp"
#include "striate/viewer/mcap/mcap_format.hpp"

namespace striate::viewer::mcap {

struct WriterOptions {
  std::string profile = "ros2";
  std::string library;  ///< who writes: "striate 0.1.0"
  Compression compression = Compression::zstd;
  std::size_t chunk_bytes = 1U << 20U;  ///< by hand: a second of images, lost where it is cut off
  bool checksums = true;  ///< false only for tests that want damage to reach what lies behind
};

/// Writes an MCAP file piece by piece, each of them whole: chunks with their indices, attachments,
/// and in the end the summary. Nothing is ever written back, so that what is cut off at a piece can
/// be read up to there.
class Writer {
 public:
  /// Takes the bytes of a piece; what it throws ends the file.
  using Sink = std::function<void(ByteView)>;

  /// Writes the head. @throws as the sink
  Writer(Sink sink, WriterOptions options);

  /// @return its number. The schema stands in the file before the first message that needs it.
  std::uint16_t add_schema(const std::string& name, const std::string& encoding,
                           const std::string& text);
  std::uint16_t add_channel(std::uint16_t schema, const std::string& topic,
                            const std::string& message_encoding);
  /// @throws as the sink, where it ends a chunk
  void write(std::uint16_t channel, std::uint64_t log_time_ns, ByteView message);
  void attach(const Attachment& attachment);
  void add_metadata(const std::string& name, const TextMap& metadata);
  /// Ends the chunk in hand.
  void end_chunk();
  /// Writes the summary; nothing may follow.
  void close();
  [[nodiscard]] const Statistics& statistics() const { return statistics_; }

 private:
  struct ChunkIndex {
    std::uint64_t begin_ns = 0;
    std::uint64_t end_ns = 0;
    std::uint64_t at = 0;
    std::uint64_t length = 0;
    std::map<std::uint16_t, std::uint64_t> message_index_at;
    std::uint64_t message_index_length = 0;
    std::uint64_t compressed = 0;
    std::uint64_t uncompressed = 0;
  };
  using MessageIndex =
      std::map<std::uint16_t, std::vector<std::pair<std::uint64_t, std::uint64_t>>>;

  void send(ByteView piece);
  void define(std::uint16_t channel);
  void append_message_indices(Bytes& piece, std::size_t chunk_length, ChunkIndex& index) const;
  void append_summary(Bytes& piece, Bytes& offsets) const;
  [[nodiscard]] std::uint32_t checksum(ByteView bytes) const;

  Sink sink_;
  WriterOptions options_;
  std::uint64_t written_ = 0;   ///< bytes
  std::uint32_t data_crc_ = 0;  ///< of all that was written
  std::vector<Schema> schemas_;
  std::vector<Channel> channels_;
  std::vector<bool> schema_is_defined_;
  std::vector<bool> channel_is_defined_;
  std::vector<std::uint32_t> sequence_;  ///< of each channel's next message
  Bytes chunk_;                          ///< records of the chunk in hand
  MessageIndex chunk_messages_;
  std::uint64_t chunk_begin_ns_ = 0;
  std::uint64_t chunk_end_ns_ = 0;
  std::vector<ChunkIndex> chunks_;
  Bytes attachment_indices_;  ///< records, ready for the summary
  Bytes metadata_indices_;
  Statistics statistics_;
  Bytes content_;  ///< of a record in hand; its room is used again
};

}  // namespace striate::viewer::mcap
