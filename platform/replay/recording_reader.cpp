#include "striate/platform/replay/recording_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include "striate/base/user_error.hpp"
#include "striate/platform/interface/plausible.hpp"
#include "striate/platform/replay/recording_codec.hpp"

namespace striate::replay {
namespace {

std::unique_ptr<std::istream> open(const std::string& file) {
  std::error_code code;
  std::unique_ptr<std::ifstream> stream;
  // A pipe may never say anything, and a device never end.
  if (std::filesystem::is_regular_file(file, code)) {
    stream = std::make_unique<std::ifstream>(file, std::ios::binary);
  }
  if (!stream || !*stream) {
    throw UserError(fmt::format("{}: cannot be read\n    is the path right?", file));
  }
  return stream;
}

/// As many of the bytes as there are. Grows with what is read, not with what is promised.
std::size_t read(std::istream& stream, std::vector<std::uint8_t>& bytes, std::size_t count) {
  constexpr std::size_t kStep = 1U << 20U;  // 1 MiB: what is taken on trust of a promised size
  bytes.clear();
  while (bytes.size() < count) {
    const std::size_t before = bytes.size();
    const std::size_t step = std::min(kStep, count - before);
    bytes.resize(before + step);
    stream.read(reinterpret_cast<char*>(bytes.data() + before), static_cast<std::streamsize>(step));
    const auto got = static_cast<std::size_t>(stream.gcount());
    if (got < step) {
      bytes.resize(before + got);
      break;
    }
  }
  return bytes.size();
}

/// Right checksums say that the bytes are what was written, not that it can be.
void refuse(const std::string& why) {
  if (!why.empty()) throw BadBytes(why);
}

}  // namespace

RecordingReader::RecordingReader(const std::string& file) : RecordingReader(open(file), file) {}

RecordingReader::RecordingReader(std::unique_ptr<std::istream> stream, std::string name)
    : stream_(std::move(stream)), name_(std::move(name)) {
  read_head();
}

void RecordingReader::read_head() {
  std::vector<std::uint8_t> head;
  read(*stream_, head, kFileHead_bytes);
  if (head.size() < kMagic.size() || !std::equal(kMagic.begin(), kMagic.end(), head.begin())) {
    throw UserError(fmt::format(
        "{}: is no recording of a run\n    one is made with: striate run TASK --world WORLD "
        "--record FILE",
        name_));
  }
  if (head.size() < kFileHead_bytes) damaged("it ends within its head");
  const auto version = ByteReader(std::span(head).subspan(kMagic.size())).take<std::uint32_t>();
  if (version != kVersion) {
    throw UserError(fmt::format(
        "{}: was recorded by another Striate: version {} of the format, this one reads {}", name_,
        version, kVersion));
  }
  at_byte_ = kFileHead_bytes;
  Chunk kind{};
  if (read_chunk(kind) == Got::end_of_file) damaged("it ends within its head");
  if (kind != Chunk::setup) damaged("it does not begin with the settings of the run");
  try {
    setup_ = decode_setup(payload_);
    refuse(why_implausible(setup_.robot));
  } catch (const BadBytes& error) {
    damaged(error.what());
  }
  at_byte_ += kChunkHead_bytes + payload_.size();
}

/// A file that was cut off ends here without a word; anything else that is not right is damage.
RecordingReader::Got RecordingReader::read_chunk(Chunk& kind) {
  std::vector<std::uint8_t> head;
  if (read(*stream_, head, kChunkHead_bytes) < kChunkHead_bytes) return Got::end_of_file;
  ByteReader reader(head);
  kind = static_cast<Chunk>(reader.take<std::uint32_t>());
  const auto size = reader.take<std::uint32_t>();
  const auto of_payload = reader.take<std::uint32_t>();
  const auto of_head = reader.take<std::uint32_t>();
  if (of_head != crc32c(std::span(head).first(kChunkHead_bytes - 4))) {
    damaged("the checksum is wrong");
  }
  if (size > kMostChunk_bytes) damaged("a part is longer than any can be");
  if (read(*stream_, payload_, size) < size) return Got::end_of_file;
  if (of_payload != crc32c(payload_)) damaged("the checksum is wrong");
  return Got::chunk;
}

bool RecordingReader::next(RecordedCycle& cycle) {
  if (ending_ != Ending::unread) return false;
  Chunk kind{};
  if (read_chunk(kind) == Got::end_of_file) {
    ending_ = Ending::cut_off;
    return false;
  }
  try {
    if (kind == Chunk::end) {
      lost_ = ByteReader(payload_).take<std::uint64_t>();
      ending_ = Ending::closed;
      return false;
    }
    if (kind != Chunk::cycle) damaged("a part of unknown kind");
    decode_cycle(payload_, cycle_);
    refuse(why_implausible(cycle_.senses));
    refuse(why_implausible(cycle_.senses.stereo));
  } catch (const BadBytes& error) {
    damaged(error.what());
  }
  if (cycle_.number <= last_number_) damaged("its cycles do not follow each other");
  last_number_ = cycle_.number;
  at_byte_ += kChunkHead_bytes + payload_.size();
  cycle = cycle_;
  return true;
}

void RecordingReader::damaged(const std::string& what) const {
  const std::string where = last_number_ == 0
                                ? std::string("before the first cycle")
                                : fmt::format("after cycle {}, which is good", last_number_);
  throw UserError(fmt::format("{}: is damaged at byte {}, {}: {}", name_, at_byte_, where, what));
}

bool is_recording(const std::string& file) {
  std::array<char, kMagic.size()> begin{};
  std::ifstream stream(file, std::ios::binary);
  stream.read(begin.data(), begin.size());
  return std::string_view(begin.data(), static_cast<std::size_t>(stream.gcount())) == kMagic;
}

}  // namespace striate::replay
