#include "striate/platform/replay/recorded_image.hpp"

#include <cstddef>
#include <cstdint>
#include <opencv2/imgcodecs.hpp>
#include <span>
#include <vector>

namespace striate::replay {
namespace {

/// Twice the widest image of a stream: what promises more is damaged
constexpr int kLongestSide_px = 8192;

std::int64_t big_endian(std::span<const std::uint8_t> four) {
  return std::int64_t{four[0]} << 24 | four[1] << 16 | four[2] << 8 | four[3];
}

}  // namespace

void put_image(ByteWriter& writer, const cv::Mat3b& image) {
  writer.put(static_cast<std::int32_t>(image.cols));
  writer.put(static_cast<std::int32_t>(image.rows));
  std::vector<std::uint8_t> png;
  if (!image.empty()) cv::imencode(".png", image, png, {cv::IMWRITE_PNG_COMPRESSION, 1});
  writer.put_block(png);
}

cv::Mat3b take_image(ByteReader& reader) {
  const auto width_px = reader.take<std::int32_t>();
  const auto height_px = reader.take<std::int32_t>();
  const auto png = reader.take_block();
  if (width_px == 0 && height_px == 0 && png.empty()) return {};
  // Where a PNG's width stands: 8 bytes of signature, 8 of the IHDR chunk's head
  constexpr std::size_t kSizeAt = 16;
  if (width_px < 1 || height_px < 1 || width_px > kLongestSide_px || height_px > kLongestSide_px ||
      png.size() < kSizeAt + 8 || big_endian(png.subspan(kSizeAt)) != width_px ||
      big_endian(png.subspan(kSizeAt + 4)) != height_px) {
    throw BadBytes("an image has not the size that was promised");
  }
  cv::Mat image;
  try {
    const cv::Mat bytes(1, static_cast<int>(png.size()), CV_8U,
                        const_cast<std::uint8_t*>(png.data()));  // imdecode only reads
    image = cv::imdecode(bytes, cv::IMREAD_COLOR);
  } catch (const cv::Exception&) {
    image.release();
  }
  if (image.type() != CV_8UC3 || image.cols != width_px || image.rows != height_px) {
    throw BadBytes("an image cannot be read");
  }
  return image;
}

}  // namespace striate::replay
