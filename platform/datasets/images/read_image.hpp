#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>

namespace striate::datasets {

/// By the suffix, in either case: what read_any_image() reads.
[[nodiscard]] bool is_image(const std::filesystem::path& file);

/// 8 or 16 bit, grey, colour, with or without alpha, as 8-bit BGR: PNG, JPEG, PGM/PPM, BMP, TIFF
/// or WebP, whatever the file is called; sides of at least 16 px and at most 40 million pixels, one
/// side at most 20 times the other, judged by the header before anything is decoded. The picture
/// stands upright, as its EXIF says. White is what PGM and PPM call it; elsewhere the greatest
/// value of the bits that are used (striate/platform/interface/pixel_range.hpp), so that 10 and 12
/// bits in 16 are not black. Throws UserError naming the file for everything else, for
/// floating-point pixels, and for a file that was cut off.
[[nodiscard]] cv::Mat3b read_any_image(const std::filesystem::path& file);

/// The same of a picture for which grey is enough.
[[nodiscard]] cv::Mat1b read_any_grey(const std::filesystem::path& file);

/// What the two eyes of a camera saw.
struct EyePair {
  cv::Mat3b left;
  cv::Mat3b right;
};

/// Both with the same white. Throws UserError, too, where the sizes differ, and where EXIF says
/// that one is not upright: then the eyes did not stand side by side, or the file does not tell the
/// truth.
[[nodiscard]] EyePair read_eye_pair(const std::filesystem::path& left,
                                    const std::filesystem::path& right);

struct GreyPair {
  cv::Mat1b left;
  cv::Mat1b right;
};

/// The same of a pair for which grey is enough.
[[nodiscard]] GreyPair read_grey_pair(const std::filesystem::path& left,
                                      const std::filesystem::path& right);

/// The same of one file that holds both eyes side by side, the left one first.
[[nodiscard]] GreyPair read_side_by_side(const std::filesystem::path& file);
[[nodiscard]] EyePair read_both_eyes(const std::filesystem::path& file);

}  // namespace striate::datasets
