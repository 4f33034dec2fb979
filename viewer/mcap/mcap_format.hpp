#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

#include "striate/base/bytes.hpp"

/// What an MCAP file consists of (mcap.dev/spec, version 0): the magic, records of one byte of
/// kind, eight of length and their content, and the magic again.
namespace striate::viewer::mcap {

inline constexpr std::array<std::uint8_t, 8> kMagic{0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};
inline constexpr std::size_t kRecordHead_bytes = 9;  ///< kind and length
/// Content of a footer: two offsets and a checksum.
inline constexpr std::size_t kFooter_bytes = 20;
/// 256 MiB, as a chunk of our recordings: what claims more is damage, not a size to allocate
inline constexpr std::uint64_t kMostRecord_bytes = 256U << 20U;
/// 64 MiB for all schemas and channels of a file, by hand: the schemas of ROS 2's own messages
/// together have less than one
inline constexpr std::uint64_t kMostDefinitions_bytes = 64U << 20U;

enum class Kind : std::uint8_t {
  header = 0x01,
  footer,
  schema,
  channel,
  message,
  chunk,
  message_index,
  chunk_index,
  attachment,
  attachment_index,
  statistics,
  metadata,
  metadata_index,
  summary_offset,
  data_end
};

using TextMap = std::map<std::string, std::string>;

/// What messages of a channel look like.
struct Schema {
  std::uint16_t id = 0;  ///< from 1; 0 stands for "none"
  std::string name;      ///< "sensor_msgs/msg/Image"
  std::string encoding;  ///< "ros2msg", "jsonschema"
  std::string text;
  friend bool operator==(const Schema&, const Schema&) = default;
};

/// Messages of one topic.
struct Channel {
  std::uint16_t id = 0;
  std::uint16_t schema = 0;      ///< 0: none
  std::string topic;             ///< "/odom"
  std::string message_encoding;  ///< "cdr", "json"
  TextMap metadata;
  friend bool operator==(const Channel&, const Channel&) = default;
};

/// A file within the file.
struct Attachment {
  std::uint64_t log_time_ns = 0;
  std::uint64_t create_time_ns = 0;
  std::string name;
  std::string media_type;  ///< "application/yaml"
  ByteView data;
};

/// What a closed file says about itself; the reader counts the same.
struct Statistics {
  std::uint64_t messages = 0;
  std::uint16_t schemas = 0;
  std::uint32_t channels = 0;
  std::uint32_t attachments = 0;
  std::uint32_t metadata = 0;
  std::uint32_t chunks = 0;
  std::uint64_t begin_ns = 0;  ///< log time of the first message
  std::uint64_t end_ns = 0;
  std::map<std::uint16_t, std::uint64_t> messages_of_channel;
};

}  // namespace striate::viewer::mcap
