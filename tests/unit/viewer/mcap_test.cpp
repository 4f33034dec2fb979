#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <sstream>

#include "striate/base/user_error.hpp"
#include "striate/viewer/mcap/mcap_reader.hpp"
#include "striate/viewer/mcap/mcap_writer.hpp"

namespace striate::viewer::mcap {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t kMessages = 40;

Bytes message_bytes(std::uint64_t k) {
  Bytes bytes(10 + 13 * (k % 5));
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i * k + k);
  return bytes;
}

/// A file of two channels, metadata and an attachment, and where its pieces end.
struct Written {
  std::string bytes;
  std::vector<std::size_t> ends;
};

Written write(Compression compression, bool checksums = true) {
  Written file;
  const auto sink = [&file](ByteView piece) {
    file.bytes.append(piece.begin(), piece.end());
    file.ends.push_back(file.bytes.size());
  };
  Writer writer(sink, {.library = "striate test",
                       .compression = compression,
                       .chunk_bytes = 300,
                       .checksums = checksums});
  writer.add_metadata("striate", {{"task", "corridor"}, {"seed", "7"}});
  const auto schema = writer.add_schema("std_msgs/msg/String", "ros2msg", "string data\n");
  const auto one = writer.add_channel(schema, "/one", "cdr");
  const auto two = writer.add_channel(0, "/two", "json");
  for (std::uint64_t k = 0; k < kMessages; ++k) {
    writer.write(k % 3 == 0 ? two : one, 1000 * k, message_bytes(k));
  }
  const Bytes task(100, 't');
  writer.attach({5, 6, "task.yaml", "application/yaml", task});
  writer.close();
  return file;
}

Reader reader_of(const std::string& bytes) {
  return {std::make_unique<std::istringstream>(bytes, std::ios::binary), "run.mcap"};
}

class EveryCompression : public testing::TestWithParam<Compression> {};
INSTANTIATE_TEST_SUITE_P(Mcap, EveryCompression,
                         testing::Values(Compression::none, Compression::zstd, Compression::lz4));

TEST_P(EveryCompression, WhatIsWrittenIsReadBack) {
  Reader reader = reader_of(write(GetParam()).bytes);
  EXPECT_EQ(reader.profile(), "ros2");
  EXPECT_EQ(reader.library(), "striate test");
  Message message;
  std::uint64_t read = 0;
  while (reader.next(message)) {
    EXPECT_EQ(message.log_time_ns, 1000 * read);
    EXPECT_EQ(message.publish_time_ns, 1000 * read);
    EXPECT_EQ(Bytes(message.data.begin(), message.data.end()), message_bytes(read));
    const Channel& channel = reader.channel_of(message);
    EXPECT_EQ(channel.topic, read % 3 == 0 ? "/two" : "/one");
    EXPECT_EQ(reader.schema_of(channel).name, read % 3 == 0 ? "" : "std_msgs/msg/String");
    ++read;
  }
  EXPECT_EQ(read, kMessages);
  EXPECT_EQ(reader.ending(), Ending::closed);
  EXPECT_EQ(reader.metadata().at("striate").at("seed"), "7");
  ASSERT_EQ(reader.attachments().size(), 1U);
  EXPECT_EQ(reader.read(reader.attachments().front()), Bytes(100, 't'));
  EXPECT_GT(reader.counted().chunks, 3U);
}

TEST_P(EveryCompression, AFileCutOffAnywhereIsReadUpToItsLastWholePiece) {
  const Written file = write(GetParam());
  for (std::size_t size = 100; size < file.bytes.size(); ++size) {
    Reader reader = reader_of(file.bytes.substr(0, size));
    Message message;
    std::uint64_t read = 0;
    while (reader.next(message)) {
      ASSERT_EQ(Bytes(message.data.begin(), message.data.end()), message_bytes(read)) << size;
      ++read;
    }
    EXPECT_EQ(reader.ending(), Ending::cut_off) << size;
    // The messages of what is whole: counted from the same file, cut at the end of that piece.
    std::size_t whole = 0;
    for (const std::size_t end : file.ends) whole = end <= size ? end : whole;
    Reader of_whole = reader_of(file.bytes.substr(0, whole));
    while (of_whole.next(message)) {
    }
    // A chunk before its index is whole enough.
    EXPECT_GE(read, of_whole.counted().messages) << size;
  }
}

TEST_P(EveryCompression, AnyChangedByteOfTheDataIsToldWithItsPlace) {
  const Written file = write(GetParam());
  std::size_t told = 0;
  for (std::size_t at = 8; at < file.bytes.size(); ++at) {
    std::string bytes = file.bytes;
    bytes[at] = static_cast<char>(bytes[at] ^ 0x10);
    try {
      Reader reader = reader_of(bytes);
      Message message;
      while (reader.next(message)) {
      }
      // Only its last magic says that a file was closed.
      EXPECT_TRUE(reader.ending() == Ending::cut_off && at + 8 >= bytes.size()) << at;
    } catch (const UserError& error) {
      ++told;
      EXPECT_THAT(error.what(), HasSubstr("run.mcap: is damaged at byte ")) << at;
    }
  }
  EXPECT_EQ(told, file.bytes.size() - 16);
}

TEST(McapReader, SaysWhatIsNoMcapFile) {
  EXPECT_THROW(
      {
        try {
          reader_of("not one at all");
        } catch (const UserError& error) {
          EXPECT_STREQ(error.what(), "run.mcap: is no MCAP file: it does not begin as one");
          throw;
        }
      },
      UserError);
  EXPECT_THROW(reader_of(""), UserError);
  EXPECT_THROW(Reader("/dev/zero"), UserError);
}

/// A chunk that claims 2^60 bytes, without checksums to stop it earlier.
TEST(McapReader, TakesNoMemoryForASizeThatIsOnlyClaimed) {
  std::string bytes = write(Compression::zstd, false).bytes;
  const std::size_t name = bytes.find("zstd");
  // Before the compression's name: size (8), checksum (4), length of the name (4)
  bytes[name - 4 - 4 - 1] = 0x10;
  Reader reader = reader_of(bytes);
  Message message;
  EXPECT_THROW(
      {
        try {
          reader.next(message);
        } catch (const UserError& error) {
          EXPECT_THAT(error.what(), HasSubstr("a chunk is larger than any that is read"));
          throw;
        }
      },
      UserError);
}

TEST(McapWriter, ThatCannotWriteLeavesWhatWasWhole) {
  std::string file;
  const auto sink = [&file](ByteView piece) {
    if (file.size() + piece.size() > 1500) throw std::runtime_error("No space left on device");
    file.append(piece.begin(), piece.end());
  };
  Writer writer(sink, {.library = "test", .compression = Compression::none, .chunk_bytes = 300});
  const auto channel = writer.add_channel(0, "/one", "json");
  EXPECT_THROW(
      {
        for (std::uint64_t k = 0; k < kMessages; ++k) writer.write(channel, k, message_bytes(k));
      },
      std::runtime_error);
  Reader reader = reader_of(file);
  Message message;
  while (reader.next(message)) {
  }
  EXPECT_EQ(reader.ending(), Ending::cut_off);
  EXPECT_GT(reader.counted().messages, 3U);
}

}  // namespace
}  // namespace striate::viewer::mcap
