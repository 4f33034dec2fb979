#include <fmt/format.h>

#include <cstdio>

#include "striate/base/crc32.hpp"
#include "striate/base/user_error.hpp"
#include "striate/viewer/mcap/mcap_reader.hpp"

/// Prints what our reader finds in an MCAP file, a line a message, for mcap.sh to compare.
int main(int argc, char** argv) {
  using namespace striate;
  using namespace striate::viewer::mcap;
  if (argc != 2) return 2;
  try {
    Reader reader(argv[1]);
    Message message;
    while (reader.next(message)) {
      const Channel& channel = reader.channel_of(message);
      fmt::print("{} {} {} {} {} {}\n", channel.topic, reader.schema_of(channel).name,
                 message.sequence, message.log_time_ns, message.data.size(), crc32(message.data));
    }
    for (const AttachmentPlace& place : reader.attachments()) {
      fmt::print("attachment {} {} {}\n", place.name, place.size, crc32(reader.read(place)));
    }
    for (const auto& [name, map] : reader.metadata()) {
      for (const auto& [key, value] : map) fmt::print("metadata {} {}={}\n", name, key, value);
    }
    fmt::print("{}\n", reader.ending() == Ending::closed ? "closed" : "cut off");
  } catch (const UserError& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
  return 0;
}
