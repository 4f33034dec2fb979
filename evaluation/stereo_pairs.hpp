#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

/// Stereo pairs with ground truth, as they lie in folders.
namespace striate::evaluation {

/// One folder that holds a pair.
struct StereoFolder {
  std::string name;            ///< of the folder
  std::filesystem::path left;  ///< rectified images
  std::filesystem::path right;
  std::filesystem::path truth;         ///< disparity of the left image, PNG or PFM
  std::filesystem::path right_truth;   ///< of the right one; empty: implied by the left one
  std::filesystem::path seen_by_both;  ///< a mask, 255: judged; empty: where both truths agree
  double truth_per_px = 1.0;           ///< values of a PNG for one pixel; 0 is unknown
};

struct StereoFolders {
  std::vector<StereoFolder> pairs;   ///< sorted by path
  std::vector<std::string> skipped;  ///< folders with images but without ground truth
};

/// All pairs in `root` and below it: Middlebury 2003 (imL, imR, groundtruth / 4, nonocc, or im2,
/// im6, disp2, disp6 / 4), 2006 (view1, view5, disp1, disp5 / 3), 2014 (im0, im1, disp0.pfm), and
/// left, right, disparity.pfm; all images PNG. Throws UserError if `root` is no folder.
[[nodiscard]] StereoFolders find_stereo_folders(const std::filesystem::path& root);

/// A pair at a working size.
struct StereoPair {
  std::string name;
  cv::Mat1b left, right;            ///< grey, 8 bits
  cv::Mat1w fine_left, fine_right;  ///< the same in sixteenths of a grey level
  cv::Mat1f truth_px;  ///< disparity at that size; NaN: unknown or not seen by both eyes
};

/// Images scaled by area, truth by the nearest pixel. Throws UserError for what cannot be read
/// and for images of different sizes.
[[nodiscard]] StereoPair read_stereo_pair(const StereoFolder& folder, cv::Size size);

}  // namespace striate::evaluation
