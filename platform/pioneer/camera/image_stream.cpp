#include "striate/platform/pioneer/camera/image_stream.hpp"

#include <array>
#include <cmath>
#include <cstring>

namespace striate::pioneer::image_stream {
namespace {

/// First bytes of every image's packet; image_stream.hpp
constexpr std::array<std::uint8_t, 4> kMagic{'S', 'T', 'P', 'P'};
/// First bytes of questions and of times; image_stream.hpp
constexpr std::array<std::uint8_t, 4> kTimeMagic{'S', 'T', 'P', 'E'};
constexpr std::size_t kQuestion = 8;  // bytes of a question; image_stream.hpp
constexpr std::size_t kTime = 16;     // bytes of a time; image_stream.hpp
/// Of the other side's questions, so much waits at most: one comes four times a second
constexpr std::size_t kMostQuestions = 4096;
/// 200 years: fits in the nanoseconds of a Duration, and is more than a clock since its start shows
constexpr std::uint64_t kLatest_us = 1000ULL * 1000ULL * 86400ULL * 365ULL * 200ULL;
constexpr double kMilli = 1e-3;  // units of the header: ms, and 1/1000 px
constexpr double kMicro = 1e-6;  // units of the header: us and um

std::uint32_t in_units(double value, double unit) {
  return static_cast<std::uint32_t>(std::lround(std::max(0.0, value) / unit));
}

void append_rows(Bytes& to, const cv::Mat3b& image) {
  const std::size_t row = 3 * static_cast<std::size_t>(image.cols);
  for (int v = 0; v < image.rows; ++v) append(to, ByteView(image.ptr(v), row));
}

struct Header {
  std::uint32_t number = 0;
  std::uint32_t stamp_ms = 0;
  std::uint32_t age_us = 0;
  std::uint32_t encoding = 0;
  int width_px = 0;
  int height_px = 0;
  StereoFrame frame;
  std::size_t size = 0;

  [[nodiscard]] std::size_t one_image() const {
    return 3 * static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px);
  }
  [[nodiscard]] bool makes_sense() const {
    return encoding == 0 && width_px >= 1 && width_px <= kWidest_px && height_px >= 1 &&
           height_px <= kWidest_px && size == 2 * one_image() && frame.focal_px > 0.0 &&
           frame.baseline_m > 0.0;
  }
};

Header read_header(ByteView bytes) {
  ByteReader reader(bytes.subspan(kMagic.size()), ByteReader::Beyond::zero);
  Header header;
  header.number = reader.u32();
  header.stamp_ms = reader.u32();
  header.age_us = reader.u32();
  header.encoding = reader.u32();
  header.width_px = reader.u16();
  header.height_px = reader.u16();
  header.frame.focal_px = kMilli * reader.u32();
  header.frame.centre_u_px = kMilli * reader.u32();
  header.frame.centre_v_px = kMilli * reader.u32();
  header.frame.baseline_m = kMicro * reader.u32();
  header.size = reader.u32();
  return header;
}

}  // namespace

Bytes encode(const StereoFrame& frame, std::uint32_t number) {
  ByteWriter writer;
  for (const std::uint8_t byte : kMagic) writer.u8(byte);
  writer.u32(number);
  writer.u32(static_cast<std::uint32_t>(to_seconds(frame.stamp) / kMilli));
  writer.u32(0);
  writer.u32(0);
  writer.u16(static_cast<std::uint16_t>(frame.left.cols));
  writer.u16(static_cast<std::uint16_t>(frame.left.rows));
  writer.u32(in_units(frame.focal_px, kMilli));
  writer.u32(in_units(frame.centre_u_px, kMilli));
  writer.u32(in_units(frame.centre_v_px, kMilli));
  writer.u32(in_units(frame.baseline_m, kMicro));
  const std::size_t size = 2 * 3 * frame.left.total();
  writer.u32(static_cast<std::uint32_t>(size));
  Bytes packet = writer.bytes();
  packet.reserve(kHeader + size);
  append_rows(packet, frame.left);
  append_rows(packet, frame.right);
  return packet;
}

void set_age(Bytes& packet, Duration age) {
  const auto age_us = std::chrono::duration_cast<std::chrono::microseconds>(age).count();
  ByteWriter writer;
  writer.u32(static_cast<std::uint32_t>(std::max<std::int64_t>(0, age_us)));
  std::copy(writer.bytes().begin(), writer.bytes().end(), packet.begin() + kAgeAt);
}

Bytes ask(std::uint32_t question) {
  ByteWriter writer;
  for (const std::uint8_t byte : kTimeMagic) writer.u8(byte);
  writer.u32(question);
  return writer.bytes();
}

Bytes tell_time(std::uint32_t question, Duration sender_clock) {
  const auto us = static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(sender_clock).count());
  ByteWriter writer;
  for (const std::uint8_t byte : kTimeMagic) writer.u8(byte);
  writer.u32(question);
  writer.u32(static_cast<std::uint32_t>(us & 0xffffffffU));
  writer.u32(static_cast<std::uint32_t>(us >> 32U));
  return writer.bytes();
}

void Reader::push(ByteView bytes) {
  if (at_ > 0) {
    buffer_.erase(buffer_.begin(), buffer_.begin() + static_cast<std::ptrdiff_t>(at_));
    at_ = 0;
  }
  append(buffer_, bytes);
}

void Reader::clear() {
  buffer_.clear();
  at_ = 0;
  told_.reset();
  answers_.clear();
}

Reader::Found Reader::find() {
  constexpr std::size_t kSame = kMagic.size() - 1;  // the two kinds differ in the last byte
  while (at_ < buffer_.size()) {
    const std::size_t left = buffer_.size() - at_;
    const auto begin = buffer_.begin() + static_cast<std::ptrdiff_t>(at_);
    const std::size_t known = std::min(left, kSame);
    if (std::equal(begin, begin + static_cast<std::ptrdiff_t>(known), kMagic.begin())) {
      if (left <= kSame) return Found::nothing;
      if (begin[kSame] == kMagic[kSame]) return left >= kHeader ? Found::image : Found::nothing;
      if (begin[kSame] == kTimeMagic[kSame]) return left >= kTime ? Found::time : Found::nothing;
    }
    ++at_;
    ++counters_.junk_bytes;
  }
  return Found::nothing;
}

void Reader::take_time() {
  ByteReader reader(ByteView(buffer_).subspan(at_ + kTimeMagic.size()), ByteReader::Beyond::zero);
  const std::uint32_t question = reader.u32();
  const std::uint64_t low = reader.u32();
  const std::uint64_t high = reader.u32();
  // Junk that passes for a time must fit in a Duration's nanoseconds.
  const auto sent = std::chrono::microseconds((high << 32U | low) % kLatest_us);
  at_ += kTime;
  if (question == 0) {
    told_ = sent;
  } else {
    answers_.push_back({question, sent});
  }
}

std::optional<Image> Reader::take_image() {
  const ByteView left = ByteView(buffer_).subspan(at_);
  const Header header = read_header(left.first(kHeader));
  if (left.size() < kHeader + header.size) return std::nullopt;
  Image image;
  image.frame = header.frame;
  image.number = header.number;
  image.age = std::chrono::microseconds(header.age_us);
  image.stamp = std::chrono::milliseconds(header.stamp_ms);
  image.sent = std::exchange(told_, std::nullopt);
  for (cv::Mat3b* eye : {&image.frame.left, &image.frame.right}) {
    const std::size_t from = kHeader + (eye == &image.frame.left ? 0 : header.one_image());
    eye->create(header.height_px, header.width_px);
    std::memcpy(eye->data, left.data() + from, header.one_image());
  }
  at_ += kHeader + header.size;
  ++counters_.pictures;
  return image;
}

std::optional<Image> Reader::next() {
  for (Found found = find(); found != Found::nothing; found = find()) {
    if (found == Found::time) {
      take_time();
    } else if (!read_header(ByteView(buffer_).subspan(at_, kHeader)).makes_sense()) {
      ++counters_.bad_headers;
      ++at_;
    } else {
      return take_image();
    }
  }
  return std::nullopt;
}

std::optional<std::uint32_t> QuestionReader::next() {
  while (buffer_.size() >= kQuestion) {
    if (std::equal(kTimeMagic.begin(), kTimeMagic.end(), buffer_.begin())) {
      ByteReader reader(ByteView(buffer_).subspan(kTimeMagic.size()), ByteReader::Beyond::zero);
      const std::uint32_t question = reader.u32();
      buffer_.erase(buffer_.begin(), buffer_.begin() + kQuestion);
      return question;
    }
    // What is no question is nothing at all.
    if (buffer_.size() > kMostQuestions) {
      buffer_.clear();
    } else {
      buffer_.erase(buffer_.begin());
    }
  }
  return std::nullopt;
}

}  // namespace striate::pioneer::image_stream
