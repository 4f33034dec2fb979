#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

namespace striate::evaluation {

/// As the PhotoTourism patches that descriptors are compared on
inline constexpr int kPatchSide_px = 64;
inline constexpr int kMosaicPatches = 16;  ///< along each side of a mosaic

/// Two patches and whether they show the same place.
struct PatchPair {
  int first = 0;  ///< number of the patch in its set
  int second = 0;
  bool same = false;
};

/// Normalised patches of 64x64 px (frame in the middle, its orientation along +u) as mosaics of
/// 16x16 patches, row by row: the layout of Brown, Winder and Lowe's patch data.
struct PatchSet {
  std::vector<cv::Mat1b> mosaics;  ///< 1024x1024 px
  int count = 0;
  std::vector<PatchPair> pairs;

  /// Adds a 64x64 patch and returns its number.
  int add(const cv::Mat1b& patch);
  [[nodiscard]] cv::Mat1b patch(int number) const;  ///< a view
};

/// Centre of a patch in its mosaic: between the four middle pixels.
[[nodiscard]] cv::Point2f patch_centre_px(int number);

}  // namespace striate::evaluation
