#include "striate/viewer/mcap/record_bytes.hpp"

namespace striate::viewer::mcap {

void append_record(Bytes& to, const Schema& schema, Bytes& room) {
  room.clear();
  ByteWriter writer(room);
  writer.put(schema.id);
  writer.put_text(schema.name);
  writer.put_text(schema.encoding);
  writer.put_text(schema.text);
  append_record(to, Kind::schema, room);
}

void append_record(Bytes& to, const Channel& channel, Bytes& room) {
  room.clear();
  ByteWriter writer(room);
  writer.put(channel.id);
  writer.put(channel.schema);
  writer.put_text(channel.topic);
  writer.put_text(channel.message_encoding);
  put_map(room, channel.metadata);
  append_record(to, Kind::channel, room);
}

void append_record(Bytes& to, const Statistics& statistics, Bytes& room) {
  room.clear();
  ByteWriter writer(room);
  writer.put(statistics.messages);
  writer.put(statistics.schemas);
  writer.put(statistics.channels);
  writer.put(statistics.attachments);
  writer.put(statistics.metadata);
  writer.put(statistics.chunks);
  writer.put(statistics.begin_ns);
  writer.put(statistics.end_ns);
  put_map(room, statistics.messages_of_channel);
  append_record(to, Kind::statistics, room);
}

TextMap take_text_map(ByteReader& reader) {
  ByteReader entries(reader.take_block());
  TextMap map;
  while (entries.left() > 0) {
    std::string key = entries.take_text();
    map[std::move(key)] = entries.take_text();
  }
  return map;
}

Schema take_schema(ByteView content) {
  ByteReader reader(content);
  Schema schema;
  schema.id = reader.u16();
  schema.name = reader.take_text();
  schema.encoding = reader.take_text();
  schema.text = reader.take_text();
  if (schema.id == 0) throw BadBytes("a schema has the number 0");
  return schema;
}

Channel take_channel(ByteView content) {
  ByteReader reader(content);
  Channel channel;
  channel.id = reader.u16();
  channel.schema = reader.u16();
  channel.topic = reader.take_text();
  channel.message_encoding = reader.take_text();
  channel.metadata = take_text_map(reader);
  return channel;
}

Statistics take_statistics(ByteView content) {
  ByteReader reader(content);
  Statistics statistics;
  statistics.messages = reader.take<std::uint64_t>();
  statistics.schemas = reader.u16();
  statistics.channels = reader.u32();
  statistics.attachments = reader.u32();
  statistics.metadata = reader.u32();
  statistics.chunks = reader.u32();
  statistics.begin_ns = reader.take<std::uint64_t>();
  statistics.end_ns = reader.take<std::uint64_t>();
  ByteReader counts(reader.take_block());
  while (counts.left() > 0) {
    const std::uint16_t channel = counts.u16();
    statistics.messages_of_channel[channel] = counts.take<std::uint64_t>();
  }
  return statistics;
}

}  // namespace striate::viewer::mcap
