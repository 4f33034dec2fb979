#include "striate/platform/pioneer/camera/image_stream.hpp"

#include <array>
#include <cmath>
#include <cstring>

namespace striate::pioneer::image_stream {
namespace {

/// First bytes of every packet; image_stream.hpp
constexpr std::array<std::uint8_t, 4> kMagic{'S', 'T', 'P', 'P'};
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
  (void)reader.u32();
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
}

bool Reader::find_header() {
  while (at_ < buffer_.size()) {
    const std::size_t left = buffer_.size() - at_;
    const auto begin = buffer_.begin() + static_cast<std::ptrdiff_t>(at_);
    const std::size_t known = std::min(left, kMagic.size());
    if (std::equal(begin, begin + static_cast<std::ptrdiff_t>(known), kMagic.begin())) {
      return left >= kHeader;
    }
    ++at_;
    ++counters_.junk_bytes;
  }
  return false;
}

std::optional<Image> Reader::next() {
  while (find_header()) {
    const ByteView left = ByteView(buffer_).subspan(at_);
    const Header header = read_header(left.first(kHeader));
    if (!header.makes_sense()) {
      ++counters_.bad_headers;
      ++at_;
      continue;
    }
    if (left.size() < kHeader + header.size) return std::nullopt;
    Image image;
    image.frame = header.frame;
    image.number = header.number;
    image.age = std::chrono::microseconds(header.age_us);
    for (cv::Mat3b* eye : {&image.frame.left, &image.frame.right}) {
      const std::size_t from = kHeader + (eye == &image.frame.left ? 0 : header.one_image());
      eye->create(header.height_px, header.width_px);
      std::memcpy(eye->data, left.data() + from, header.one_image());
    }
    at_ += kHeader + header.size;
    ++counters_.pictures;
    return image;
  }
  return std::nullopt;
}

}  // namespace striate::pioneer::image_stream
