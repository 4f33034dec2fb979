#include "striate/evaluation/images/read_image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <string>
#include <vector>

#include "striate/base/user_error.hpp"
#include "striate/evaluation/images/image_header.hpp"

namespace striate::evaluation {
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

[[noreturn]] void refuse_floats(const fs::path& file) {
  throw UserError(
      fmt::format("{}: has floating-point pixels; 8 or 16 bit are needed", file.string()));
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
void check_header(const fs::path& file, const std::vector<std::uint8_t>& bytes) {
  const std::optional<ImageHeader> header = read_image_header(bytes);
  if (!header) refuse_as_unreadable(file);
  if (header->floating) refuse_floats(file);
  if (header->width_px > 0 && header->height_px > 0) {
    check_size(file, header->width_px, header->height_px);
  }
  if (!header->whole) {
    throw UserError(fmt::format("{}: is no image that can be read: it ends too early or is damaged",
                                file.string()));
  }
}

cv::Mat3b as_colour(const fs::path& file, cv::Mat& raw) {
  if (raw.depth() == CV_16U) raw.convertTo(raw, CV_8U, 1.0 / 257.0);
  cv::Mat3b image;
  switch (raw.channels()) {
    case 1:
      cv::cvtColor(raw, image, cv::COLOR_GRAY2BGR);
      return image;
    case 3:
      return raw;
    case 4:
      cv::cvtColor(raw, image, cv::COLOR_BGRA2BGR);
      return image;
    default:
      throw UserError(
          fmt::format("{}: has {} channels; 1, 3 or 4 are needed", file.string(), raw.channels()));
  }
}

}  // namespace

cv::Mat3b read_any_image(const fs::path& file) {
  const std::vector<std::uint8_t> bytes = read_bytes(file);
  check_header(file, bytes);
  cv::Mat raw;
  try {
    raw = cv::imdecode(bytes, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    raw.release();
  }
  if (raw.empty()) refuse_as_unreadable(file);
  if (raw.depth() != CV_8U && raw.depth() != CV_16U) refuse_floats(file);
  check_size(file, raw.cols, raw.rows);  // where the header did not tell, or not the truth
  return as_colour(file, raw);
}

}  // namespace striate::evaluation
