#include "striate/platform/datasets/images/raw_picture.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>
#include <vector>

#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/images/image_header.hpp"
#include "striate/platform/interface/pixel_range.hpp"

namespace striate::datasets {
namespace {

namespace fs = std::filesystem;

constexpr int kSmallestImage_px = 16;      ///< px: a V1 kernel is 15 wide
constexpr double kMostImagePixels = 40e6;  ///< above any camera here; memory stays below 1 GB
constexpr std::uintmax_t kMostBytes = 400U << 20;  ///< 40 million pixels of four times 16 bits
constexpr double kLongestShape = 20.0;  ///< width / height: more leaves no row at the working size

[[noreturn]] void refuse_as_unreadable(const fs::path& file) {
  throw UserError(fmt::format(
      "{}: is no image that can be read (PNG, JPEG, PGM/PPM, BMP, TIFF, WebP)", file.string()));
}

[[noreturn]] void refuse_depth(const fs::path& file) {
  throw UserError(
      fmt::format("{}: has floating-point pixels, or such of 32 bit; whole numbers of 8 "
                  "or 16 bit are needed",
                  file.string()));
}

std::vector<std::uint8_t> read_bytes(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) {
    throw UserError(fmt::format("{}: no such file; give the path of an image", file.string()));
  }
  if (fs::is_directory(file, error)) {
    throw UserError(fmt::format("{}: is a folder; give the path of an image", file.string()));
  }
  if (!fs::is_regular_file(file, error)) refuse_as_unreadable(file);  // a pipe may have no end
  if (fs::file_size(file, error) > kMostBytes) {
    throw UserError(fmt::format("{}: has more than {} MB; at most 40 million pixels are taken",
                                file.string(), kMostBytes >> 20));
  }
  std::ifstream in(file, std::ios::binary);
  if (!in) throw UserError(fmt::format("{}: cannot be opened", file.string()));
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void check_size(const fs::path& file, std::int64_t width_px, std::int64_t height_px) {
  const auto [shorter, longer] = std::minmax(width_px, height_px);
  const std::string is = fmt::format("{}: is {} x {} px", file.string(), width_px, height_px);
  if (shorter < kSmallestImage_px) {
    throw UserError(
        fmt::format("{}; at least {} x {} are needed", is, kSmallestImage_px, kSmallestImage_px));
  }
  if (static_cast<double>(width_px) * static_cast<double>(height_px) > kMostImagePixels) {
    throw UserError(is + "; at most 40 million pixels are taken: scale it");
  }
  if (static_cast<double>(longer) > kLongestShape * static_cast<double>(shorter)) {
    throw UserError(is + "; one side may be at most 20 times the other: cut it");
  }
}

/// Before anything is decoded: a few bytes can promise pixels that fill the memory, and decoders
/// show a file that was cut off as far as it goes, without a word.
ImageHeader checked_header(const fs::path& file, const std::vector<std::uint8_t>& bytes) {
  const std::optional<ImageHeader> header = read_image_header(bytes);
  if (!header) refuse_as_unreadable(file);
  if (header->floating) refuse_depth(file);
  if (header->width_px > 0 && header->height_px > 0) {
    check_size(file, header->width_px, header->height_px);
  }
  if (!header->whole) {
    throw UserError(fmt::format("{}: is no image that can be read: it ends too early or is damaged",
                                file.string()));
  }
  return *header;
}

}  // namespace

cv::Mat upright(const cv::Mat& image, int orientation) {
  enum { flipped_left_right = 2, half_turn, flipped_up_down, transposed, right, transverse, left };
  cv::Mat result;
  switch (orientation) {
    case flipped_left_right:
      cv::flip(image, result, 1);
      return result;
    case half_turn:
      cv::rotate(image, result, cv::ROTATE_180);
      return result;
    case flipped_up_down:
      cv::flip(image, result, 0);
      return result;
    case transposed:
      cv::transpose(image, result);
      return result;
    case right:
      cv::rotate(image, result, cv::ROTATE_90_CLOCKWISE);
      return result;
    case transverse:
      cv::rotate(image, result, cv::ROTATE_180);
      cv::transpose(result, result);
      return result;
    case left:
      cv::rotate(image, result, cv::ROTATE_90_COUNTERCLOCKWISE);
      return result;
    default:
      return image;
  }
}

RawPicture read_raw(const fs::path& file, int flags) {
  std::vector<std::uint8_t> bytes = read_bytes(file);
  RawPicture raw{{}, checked_header(file, bytes)};
  // A last number without a line's end after it is a whole file to everybody but OpenCV.
  if (raw.header.most > 0 && !raw.header.binary) bytes.push_back('\n');
  try {
    raw.pixels = cv::imdecode(bytes, flags | cv::IMREAD_IGNORE_ORIENTATION);
  } catch (const cv::Exception&) {
    raw.pixels.release();
  }
  if (raw.pixels.empty()) refuse_as_unreadable(file);
  if (raw.pixels.depth() != CV_8U && raw.pixels.depth() != CV_16U) refuse_depth(file);
  // Where the header did not tell, or not the truth.
  check_size(file, raw.pixels.cols, raw.pixels.rows);
  const bool tiff = bytes[0] == bytes[1];  // "II" or "MM": its decoder turns by itself
  if (!tiff) raw.pixels = upright(raw.pixels, raw.header.orientation);
  return raw;
}

int white_of(const RawPicture& raw, int bits) {
  constexpr int kAll = 255;  // the most that CV_8U holds
  const bool deep = raw.pixels.depth() == CV_16U;
  if (raw.header.most > 0 && (deep || raw.header.binary)) return raw.header.most;
  return deep ? most_of_bits(bits) : kAll;
}

}  // namespace striate::datasets
