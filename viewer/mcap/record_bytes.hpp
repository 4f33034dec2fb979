#pragma once

#include <cstdint>
#include <map>
#include <type_traits>

#include "striate/viewer/mcap/mcap_format.hpp"

/// Records of an MCAP file as bytes.
namespace striate::viewer::mcap {

inline void append_record(Bytes& to, Kind kind, ByteView content) {
  ByteWriter writer(to);
  writer.put(static_cast<std::uint8_t>(kind));
  writer.put(static_cast<std::uint64_t>(content.size()));
  append(to, content);
}

/// What is left of some content behind what a reader has taken from it.
[[nodiscard]] inline ByteView rest_of(ByteView content, const ByteReader& reader) {
  return content.subspan(content.size() - reader.left());
}

/// A map behind the number of its bytes.
template <class Key, class Value>
void put_map(Bytes& to, const std::map<Key, Value>& map) {
  Bytes entries;
  ByteWriter writer(entries);
  for (const auto& [key, value] : map) {
    if constexpr (std::is_arithmetic_v<Key>) {
      writer.put(key);
      writer.put(value);
    } else {
      writer.put_text(key);
      writer.put_text(value);
    }
  }
  ByteWriter(to).put_block(entries);
}

// Their second argument gives room for the content.
void append_record(Bytes& to, const Schema& schema, Bytes& room);
void append_record(Bytes& to, const Channel& channel, Bytes& room);
void append_record(Bytes& to, const Statistics& statistics, Bytes& room);

// @throws BadBytes
[[nodiscard]] Schema take_schema(ByteView content);
[[nodiscard]] Channel take_channel(ByteView content);
[[nodiscard]] Statistics take_statistics(ByteView content);
[[nodiscard]] TextMap take_text_map(ByteReader& reader);

}  // namespace striate::viewer::mcap
