#include "striate/platform/datasets/images/read_image.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

#include "striate/base/lower_case.hpp"
#include "striate/base/user_error.hpp"
#include "striate/platform/datasets/images/raw_picture.hpp"
#include "striate/platform/interface/pixel_range.hpp"

namespace striate::datasets {
namespace {

namespace fs = std::filesystem;

cv::Mat3b as_colour(const fs::path& file, const cv::Mat& raw) {
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

cv::Mat of_eight_bits(const RawPicture& raw, int bits) {
  return as_eight_bits(raw.pixels, white_of(raw, bits));
}

void refuse_turned(const fs::path& file, const RawPicture& raw) {
  if (raw.header.orientation == 1) return;
  throw UserError(fmt::format(
      "{}: its EXIF says that the camera was turned or mirrored (orientation {}); the eyes of a "
      "pair must stand side by side\n    hint: give pictures whose pixels stand upright, without "
      "that tag",
      file.string(), raw.header.orientation));
}

struct RawPair {
  RawPicture left;
  RawPicture right;
  int bits = 0;  ///< of both together
};

RawPair read_raw_pair(const fs::path& left_file, const fs::path& right_file, int flags) {
  RawPair pair{read_raw(left_file, flags), read_raw(right_file, flags)};
  refuse_turned(left_file, pair.left);
  refuse_turned(right_file, pair.right);
  const cv::Mat& left = pair.left.pixels;
  const cv::Mat& right = pair.right.pixels;
  if (left.size() != right.size()) {
    throw UserError(fmt::format(
        "{} is {} x {} but {} is {} x {}: left and right must be a rectified pair of one size",
        left_file.string(), left.cols, left.rows, right_file.string(), right.cols, right.rows));
  }
  pair.bits = std::max(bits_used(left), bits_used(right));
  return pair;
}

/// Luminance is the decoder's affair: a JPEG holds it.
constexpr int kGreyAsItIs = cv::IMREAD_GRAYSCALE | cv::IMREAD_ANYDEPTH;

}  // namespace

bool is_image(const std::filesystem::path& file) {
  constexpr const char* kSuffixes[] = {".png", ".jpg", ".jpeg", ".pgm",  ".ppm",
                                       ".pnm", ".bmp", ".tif",  ".tiff", ".webp"};
  const std::string suffix = lower_case(file.extension().string());
  return std::ranges::find(kSuffixes, suffix) != std::end(kSuffixes);
}

cv::Mat3b read_any_image(const fs::path& file) {
  const RawPicture raw = read_raw(file, cv::IMREAD_UNCHANGED);
  return as_colour(file, of_eight_bits(raw, bits_used(raw.pixels)));
}

cv::Mat1b read_any_grey(const fs::path& file) {
  const RawPicture raw = read_raw(file, kGreyAsItIs);
  return of_eight_bits(raw, bits_used(raw.pixels));
}

EyePair read_eye_pair(const fs::path& left, const fs::path& right) {
  const RawPair pair = read_raw_pair(left, right, cv::IMREAD_UNCHANGED);
  return {as_colour(left, of_eight_bits(pair.left, pair.bits)),
          as_colour(right, of_eight_bits(pair.right, pair.bits))};
}

GreyPair read_grey_pair(const fs::path& left, const fs::path& right) {
  const RawPair pair = read_raw_pair(left, right, kGreyAsItIs);
  return {of_eight_bits(pair.left, pair.bits), of_eight_bits(pair.right, pair.bits)};
}

GreyPair read_side_by_side(const fs::path& file) {
  const RawPicture raw = read_raw(file, kGreyAsItIs);
  refuse_turned(file, raw);
  const cv::Mat1b both = of_eight_bits(raw, bits_used(raw.pixels));
  const int half = both.cols / 2;
  return {both.colRange(0, half), both.colRange(half, 2 * half)};
}

EyePair read_both_eyes(const fs::path& file) {
  const RawPicture raw = read_raw(file, cv::IMREAD_UNCHANGED);
  refuse_turned(file, raw);
  const cv::Mat3b both = as_colour(file, of_eight_bits(raw, bits_used(raw.pixels)));
  const int half = both.cols / 2;
  return {both.colRange(0, half), both.colRange(half, 2 * half)};
}

}  // namespace striate::datasets
