#include "striate/platform/datasets/images/image_header.hpp"

#include <algorithm>
#include <cctype>
#include <cstddef>

#include "striate/base/crc_table.hpp"
#include "striate/platform/datasets/images/tiff_directory.hpp"

namespace striate::datasets {
namespace {

/// Sides beyond are refused anyway; products of smaller ones fit 64 bits.
constexpr std::int64_t kNoImage_px = 1'000'000;

/// The checksum of PNG chunks (ISO 3309, reflected polynomial 0xEDB88320).
std::uint32_t checksum(const ImageBytes& bytes, std::size_t from, std::size_t to) {
  // CRC-32 of PNG (ISO 3309) of every byte
  static constexpr auto kTable = reflected_crc_table(0xEDB88320U);
  std::uint32_t c = 0xFFFFFFFFU;
  for (std::size_t i = from; i < to; ++i) c = kTable[(c ^ bytes.at(i)) & 0xFFU] ^ (c >> 8);
  return ~c;
}

ImageHeader png(const ImageBytes& bytes) {
  ImageHeader header{bytes.big32(16), bytes.big32(20)};
  for (std::size_t at = 8; at + 12 <= bytes.size();) {
    const std::size_t data_end = at + 8 + bytes.big32(at);
    if (data_end + 4 > bytes.size()) break;
    if (checksum(bytes, at + 4, data_end) != bytes.big32(data_end)) break;
    if (bytes.says(at + 4, "IEND")) return header;
    if (bytes.says(at + 4, "eXIf")) header.orientation = tiff_directory(bytes, at + 8).orientation;
    at = data_end + 4;
  }
  header.whole = false;
  return header;
}

/// Start of frame of any coding: baseline, progressive, ... but not the tables that stand between.
bool is_start_of_frame(std::uint32_t marker) {
  return marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
}

ImageHeader jpeg(const ImageBytes& bytes) {
  constexpr std::uint32_t kEnd = 0xD9;           // JPEG's EOI marker (ITU-T T.81)
  constexpr std::uint32_t kApplication1 = 0xE1;  // APP1, which EXIF 2.3 lies in
  ImageHeader header;
  for (std::size_t at = 2; at + 1 < bytes.size();) {
    const std::uint32_t marker = bytes.at(at + 1);
    const bool is_marker = bytes.at(at) == 0xFF && marker != 0x00 && marker != 0xFF;
    if (!is_marker) {  // coded pixels, or fill bytes
      ++at;
      continue;
    }
    if (marker == kEnd) return header;
    if (marker == 0x01 || (marker >= 0xD0 && marker <= 0xD8)) {  // these have no length
      at += 2;
      continue;
    }
    if (is_start_of_frame(marker) && header.width_px == 0) {
      header.height_px = bytes.big16(at + 5);
      header.width_px = bytes.big16(at + 7);
    }
    if (marker == kApplication1 && bytes.says(at + 4, {"Exif\0\0", 6})) {
      header.orientation = tiff_directory(bytes, at + 10).orientation;
    }
    at += 2 + bytes.big16(at + 2);
  }
  header.whole = false;
  return header;
}

/// The next number of a PNM header; comments run from # to the end of the line. At most ten digits
/// count, so that nothing overflows.
std::int64_t pnm_number(const ImageBytes& bytes, std::size_t& at) {
  while (at < bytes.size() && std::isdigit(static_cast<int>(bytes.at(at))) == 0) {
    if (bytes.at(at) == '#') {
      while (at < bytes.size() && bytes.at(at) != '\n') ++at;
    }
    ++at;
  }
  std::int64_t value = 0;
  for (int digits = 0; std::isdigit(static_cast<int>(bytes.at(at))) != 0; ++at) {
    if (digits++ < 10) value = 10 * value + static_cast<std::int64_t>(bytes.at(at) - '0');
  }
  return value;
}

ImageHeader pnm(const ImageBytes& bytes) {
  const std::uint32_t kind = bytes.at(1) - '0';
  std::size_t at = 2;
  ImageHeader header;
  header.width_px = pnm_number(bytes, at);
  header.height_px = pnm_number(bytes, at);
  const bool small = header.width_px < kNoImage_px && header.height_px < kNoImage_px;
  const bool of_bits = kind == 1 || kind == 4;
  header.binary = kind > 3;
  if (!of_bits)
    header.most = static_cast<int>(std::clamp<std::int64_t>(pnm_number(bytes, at), 1, 65535));
  if (kind < 4 || !small) return header;
  std::int64_t row_bytes = (header.width_px + 7) / 8;
  if (kind > 4) {
    const std::int64_t sample_bytes = header.most > 255 ? 2 : 1;
    row_bytes = header.width_px * sample_bytes * (kind == 6 ? 3 : 1);
  }
  const auto there = static_cast<std::int64_t>(bytes.size()) - static_cast<std::int64_t>(at) - 1;
  header.whole = there >= row_bytes * header.height_px;
  return header;
}

ImageHeader bmp(const ImageBytes& bytes) {
  ImageHeader header;
  if (bytes.little32(14) == 12) {  // the oldest header has 16-bit sizes
    header.width_px = bytes.little16(18);
    header.height_px = bytes.little16(20);
    return header;
  }
  header.width_px = static_cast<std::int32_t>(bytes.little32(18));
  header.height_px = static_cast<std::int32_t>(bytes.little32(22));
  if (header.height_px < 0) header.height_px = -header.height_px;  // stored top down
  const bool plain = bytes.little32(30) == 0;
  const std::int64_t row_bytes = (header.width_px * bytes.little16(28) + 31) / 32 * 4;
  const bool small = header.width_px < kNoImage_px && header.height_px < kNoImage_px;
  if (plain && small && header.width_px > 0) {
    header.whole = static_cast<std::int64_t>(bytes.size()) >=
                   bytes.little32(10) + row_bytes * header.height_px;
  }
  return header;
}

ImageHeader tiff(const ImageBytes& bytes) {
  const TiffDirectory directory = tiff_directory(bytes, 0);
  ImageHeader header{directory.width_px, directory.height_px};
  header.orientation = directory.orientation;
  header.whole = header.width_px > 0 && header.height_px > 0;
  return header;
}

ImageHeader webp(const ImageBytes& bytes) {
  ImageHeader header;
  if (bytes.says(12, "VP8X")) {  // 24 bits each, less one
    header.width_px = 1 + (bytes.little32(24) & 0xFFFFFFU);
    header.height_px = 1 + (bytes.little32(27) & 0xFFFFFFU);
  } else if (bytes.says(12, "VP8L")) {  // 14 bits each, less one, behind one byte of signature
    header.width_px = 1 + (bytes.little32(21) & 0x3FFFU);
    header.height_px = 1 + (bytes.little32(21) >> 14 & 0x3FFFU);
  } else if (bytes.says(12, "VP8 ")) {  // 14 bits each, the upper two are a scale
    header.width_px = bytes.little16(26) & 0x3FFFU;
    header.height_px = bytes.little16(28) & 0x3FFFU;
  }
  header.whole = std::uint64_t{bytes.little32(4)} + 8 <= bytes.size();
  for (std::size_t at = 12; at + 8 <= bytes.size();) {  // chunks of an even size
    const std::size_t size = bytes.little32(at + 4);
    if (bytes.says(at, "EXIF")) {
      const bool named = bytes.says(at + 8, {"Exif\0\0", 6});  // some begin as a JPEG's does
      header.orientation = tiff_directory(bytes, at + (named ? 14 : 8)).orientation;
    }
    at += 8 + size + size % 2;
  }
  return header;
}

}  // namespace

std::optional<ImageHeader> read_image_header(std::span<const std::uint8_t> data) {
  const ImageBytes bytes(data);
  if (bytes.says(0, "\x89PNG\r\n\x1a\n")) return png(bytes);
  if (bytes.says(0, "\xFF\xD8\xFF")) return jpeg(bytes);
  if (bytes.says(0, "BM")) return bmp(bytes);
  if (bytes.says(0, {"II*\0", 4}) || bytes.says(0, {"MM\0*", 4})) return tiff(bytes);
  if (bytes.says(0, "RIFF") && bytes.says(8, "WEBP")) return webp(bytes);
  if (bytes.at(0) == 'P' && bytes.at(1) >= '1' && bytes.at(1) <= '6') return pnm(bytes);
  const bool pfm = bytes.says(0, "Pf") || bytes.says(0, "PF");
  const bool radiance = bytes.says(0, "#?RADIANCE") || bytes.says(0, "#?RGBE");
  if (pfm || radiance || bytes.says(0, "\x76\x2f\x31\x01")) {
    ImageHeader header;
    header.floating = true;
    return header;
  }
  return std::nullopt;
}

}  // namespace striate::datasets
