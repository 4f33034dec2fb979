#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace striate::evaluation {

/// Images of one flat scene and how the first maps onto each of the others.
struct HomographySequence {
  std::string name;
  std::vector<cv::Mat1b> pictures;  ///< the first is the reference
  std::vector<cv::Matx33d> to;      ///< one a further image: from the first's pixels to its own
};

/// The folder itself, or each of its subfolders in order of name, where it holds
///   Oxford:   img1.ppm, img2.ppm, H1to2p, ...
///   HPatches: 1.ppm, 2.ppm, H_1_2, ...     (ppm, pgm, png, jpg, jpeg or bmp)
/// @throws UserError where there is no such folder, saying what is expected.
[[nodiscard]] std::vector<std::filesystem::path> find_homography_sequences(
    const std::filesystem::path& folder);

/// @throws UserError for an image or homography that cannot be read.
[[nodiscard]] HomographySequence read_homography_sequence(const std::filesystem::path& folder);

/// Where (u, v) lies in the other image.
[[nodiscard]] cv::Point2d projected(const cv::Matx33d& homography, cv::Point2d at);

}  // namespace striate::evaluation
