#pragma once

#include <cstdint>
#include <istream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "striate/viewer/mcap/mcap_format.hpp"
#include "striate/viewer/mcap/record_reader.hpp"

namespace striate::viewer::mcap {

/// How a file ends.
enum class Ending : std::uint8_t {
  unread,   ///< there is more to come
  closed,   ///< whole, with its summary
  cut_off,  ///< whoever wrote it was killed, or the disk was full: all whole chunks are there
};

/// A message as it stands in the file.
struct Message {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;
  std::uint64_t log_time_ns = 0;
  std::uint64_t publish_time_ns = 0;
  ByteView data;  ///< until the next message is read
};

/// Where an attachment lies.
struct AttachmentPlace {
  std::string name;
  std::string media_type;
  std::uint64_t size = 0;  ///< bytes
  std::uint64_t at = 0;    ///< of its record in the file
};

/// Reads an MCAP file from its beginning, of any writer, message after message in the order of the
/// file. Checksums are compared where the writer made them. Holds one chunk at a time.
class Reader {
 public:
  /// @throws UserError where the file cannot be read, is no MCAP file, or is damaged at its head
  explicit Reader(const std::string& file);
  /// The same from any stream that can be sought in; `name` is for messages.
  Reader(std::unique_ptr<std::istream> stream, std::string name);

  /// The next message, or false at the end. @throws UserError naming the place of any damage
  bool next(Message& message);

  // Of what was read so far.
  [[nodiscard]] const std::map<std::uint16_t, Channel>& channels() const { return channels_; }
  [[nodiscard]] const std::map<std::uint16_t, Schema>& schemas() const { return schemas_; }
  [[nodiscard]] const Channel& channel_of(const Message& message) const {
    return channels_.at(message.channel);
  }
  /// An empty one for a channel without.
  [[nodiscard]] const Schema& schema_of(const Channel& channel) const;
  [[nodiscard]] const std::vector<AttachmentPlace>& attachments() const { return attachments_; }
  /// @throws UserError where it is damaged
  [[nodiscard]] Bytes read(const AttachmentPlace& attachment);
  /// By name.
  [[nodiscard]] const std::map<std::string, TextMap>& metadata() const { return metadata_; }
  [[nodiscard]] const Statistics& counted() const { return counted_; }
  [[nodiscard]] Ending ending() const { return ending_; }
  [[nodiscard]] const std::string& profile() const { return profile_; }
  [[nodiscard]] const std::string& library() const { return library_; }
  [[nodiscard]] const std::string& name() const { return records_.name(); }

 private:
  enum class Part : std::uint8_t { data, summary };
  void read_head();
  bool next_in_chunk(Message& message);
  bool take_data(const Record& record, Message& message);
  void take_definition(const Record& record);
  void take_metadata(ByteView content);
  void take_message(ByteView content, Message& message);
  void open_chunk(ByteView content);
  [[nodiscard]] AttachmentPlace take_attachment(ByteView content, ByteView& data) const;
  void take_data_end(ByteView content);
  void take_summary(const Record& record);
  void take_footer(ByteView content);
  void count_definitions(std::size_t bytes);
  [[noreturn]] void damaged(const std::string& what) const;

  RecordReader records_;
  Part part_ = Part::data;
  Bytes chunk_;
  std::size_t in_chunk_ = 0;  ///< read of it
  std::uint64_t summary_at_ = 0;
  std::uint64_t definitions_bytes_ = 0;
  std::map<std::uint16_t, Channel> channels_;
  std::map<std::uint16_t, Schema> schemas_;
  std::vector<AttachmentPlace> attachments_;
  std::map<std::string, TextMap> metadata_;
  Statistics counted_;
  Ending ending_ = Ending::unread;
  std::string profile_;
  std::string library_;
};

/// Whether a file begins as an MCAP file does.
[[nodiscard]] bool is_mcap(const std::string& file);

}  // namespace striate::viewer::mcap
