#include "striate/agent/pictures/animated_png.hpp"

#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <string_view>

#include "striate/base/crc_table.hpp"

namespace striate::agent::pictures {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";  // PNG Specification, section 5.2
constexpr std::size_t kChunkFrame_bytes = 12;  // length, kind and checksum: PNG Spec., section 5.3

std::string big32(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) {
    bytes += static_cast<char>((value >> static_cast<unsigned>(shift)) & 0xFFU);
  }
  return bytes;
}

std::uint32_t read_big32(std::string_view bytes) {
  std::uint32_t value = 0;
  for (const char byte : bytes.substr(0, 4)) value = (value << 8) | static_cast<std::uint8_t>(byte);
  return value;
}

std::string chunk(std::string_view kind, std::string_view content) {
  static constexpr auto kTable = reflected_crc_table(0xEDB88320U);  // of CRC-32, ISO 3309
  const std::string body = std::string(kind) + std::string(content);
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const char byte : body)
    crc = (crc >> 8) ^ kTable[(crc ^ static_cast<std::uint8_t>(byte)) & 0xFFU];
  return big32(static_cast<std::uint32_t>(content.size())) + body + big32(~crc);
}

/// All chunks of one kind of a PNG, their contents joined.
std::string contents(std::string_view png, std::string_view kind) {
  std::string joined;
  for (std::size_t at = kSignature.size(); at + kChunkFrame_bytes <= png.size();) {
    const std::size_t length = read_big32(png.substr(at));
    if (png.substr(at + 4, 4) == kind) joined += png.substr(at + 8, length);
    at += kChunkFrame_bytes + length;
  }
  return joined;
}

}  // namespace

void AnimatedPng::add(const cv::Mat3b& frame) {
  if (!fits(frame)) {
    throw std::invalid_argument("every frame of a moving picture has the size of the first");
  }
  std::vector<std::uint8_t> encoded;
  cv::imencode(".png", frame, encoded, {cv::IMWRITE_PNG_COMPRESSION, 9});
  const std::string_view png(reinterpret_cast<const char*>(encoded.data()), encoded.size());
  size_ = frame.size();
  header_ = contents(png, "IHDR");
  frames_.push_back(contents(png, "IDAT"));
}

std::string AnimatedPng::bytes() const {
  if (frames_.empty()) throw std::logic_error("a moving picture without a frame");
  std::uint32_t sequence = 0;
  std::string file(kSignature);
  file += chunk("IHDR", header_);
  file += chunk("acTL", big32(static_cast<std::uint32_t>(frames_.size())) + big32(0));  // for ever
  for (const std::string& frame : frames_) {
    std::string control = big32(sequence++) + big32(static_cast<std::uint32_t>(size_.width)) +
                          big32(static_cast<std::uint32_t>(size_.height)) + big32(0) + big32(0);
    const auto delay = static_cast<std::uint32_t>(delay_ms_);
    control += big32((delay << 16) | 1000U);  // numerator and denominator of seconds
    control += std::string(2, '\0');          // the frame stays, and replaces what was there
    file += chunk("fcTL", control);
    file += &frame == &frames_.front() ? chunk("IDAT", frame)
                                       : chunk("fdAT", big32(sequence++) + frame);
  }
  return file + chunk("IEND", "");
}

}  // namespace striate::agent::pictures
