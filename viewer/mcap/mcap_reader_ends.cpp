#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "striate/base/crc32.hpp"
#include "striate/base/user_error.hpp"
#include "striate/viewer/mcap/mcap_reader.hpp"
#include "striate/viewer/mcap/record_bytes.hpp"

namespace striate::viewer::mcap {
AttachmentPlace Reader::take_attachment(ByteView content, ByteView& data) const {
  ByteReader reader(content);
  AttachmentPlace place;
  (void)reader.take<std::uint64_t>();  // when it was logged and made
  (void)reader.take<std::uint64_t>();
  place.name = reader.take_text();
  place.media_type = reader.take_text();
  place.size = reader.take<std::uint64_t>();
  place.at = records_.at();
  if (reader.left() < 4 || place.size != reader.left() - 4) {
    throw BadBytes("an attachment has not the size that was promised");
  }
  data = rest_of(content, reader).first(place.size);
  const std::uint32_t crc = ByteReader(content.last(4)).u32();
  if (crc != 0 && crc != crc32(content.first(content.size() - 4))) {
    throw BadBytes(fmt::format("the checksum of the attachment '{}' is wrong", place.name));
  }
  return place;
}

Bytes Reader::read(const AttachmentPlace& attachment) {
  Record record;
  ByteView data;
  try {
    if (!records_.read_at(attachment.at, record) || record.kind != Kind::attachment) {
      throw BadBytes("no attachment is there");
    }
    (void)take_attachment(record.content, data);
  } catch (const BadBytes& error) {
    damaged(error.what());
  }
  return {data.begin(), data.end()};
}

void Reader::take_data_end(ByteView content) {
  const std::uint32_t crc = ByteReader(content).u32();
  if (crc != 0 && crc != records_.crc_before()) throw BadBytes("the checksum of all data is wrong");
  part_ = Part::summary;
  records_.begin_crc();
  summary_at_ = records_.behind();
}

void Reader::take_summary(const Record& record) {
  if (record.kind == Kind::footer) return take_footer(record.content);
  if (record.kind == Kind::schema || record.kind == Kind::channel) return take_definition(record);
  if (record.kind != Kind::statistics) return;
  const Statistics said = take_statistics(record.content);
  if (said.messages != counted_.messages || said.chunks != counted_.chunks ||
      said.attachments != counted_.attachments) {
    throw BadBytes(
        fmt::format("it should hold {} messages in {} chunks and {} attachments, and "
                    "holds {} in {} and {}",
                    said.messages, said.chunks, said.attachments, counted_.messages,
                    counted_.chunks, counted_.attachments));
  }
}

void Reader::take_footer(ByteView content) {
  ByteReader reader(content);
  const auto summary_at = reader.take<std::uint64_t>();
  (void)reader.take<std::uint64_t>();  // where the offsets begin: the summary was read through
  const std::uint32_t crc = reader.u32();
  if (summary_at != 0 && summary_at != summary_at_) {
    throw BadBytes("its footer names another place for the summary");
  }
  if (crc != 0) {
    Bytes head;
    append_record(head, Kind::footer, content);
    if (crc != crc32(ByteView(head).first(head.size() - 4), records_.crc_before())) {
      throw BadBytes("the checksum of the summary is wrong");
    }
  }
  ending_ = records_.closed() ? Ending::closed : Ending::cut_off;
}

bool is_mcap(const std::string& file) {
  std::array<char, kMagic.size()> begin{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(begin.data(), begin.size());
  return stream.gcount() == static_cast<std::streamsize>(begin.size()) &&
         std::equal(kMagic.begin(), kMagic.end(), begin.begin(),
                    [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); });
}

}  // namespace striate::viewer::mcap
