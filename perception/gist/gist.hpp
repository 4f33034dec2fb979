#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "striate/perception/v1/v1_cells.hpp"

namespace striate::perception {

/// Wavelengths: 4, 8 and 16 px of an image of 160 x 120
inline constexpr int kGistScales = 3;
/// Parts of the image each way; Oliva and Torralba (2001) take 4 x 4 to 8 x 8
inline constexpr int kGistParts = 4;
inline constexpr int kGistValues = kGistScales * kGistParts * kGistParts * kOrientations;

/// What an image is like as a whole: how strongly the complex cells of each scale and orientation
/// answer in each part of it. 384 bytes, as they may be stored.
struct Gist {
  /// By scale (fine first), row of parts, column of parts, orientation. Their length is about
  /// kGistLength, whatever the light; of a blank image all are 0.
  std::array<std::uint8_t, kGistValues> values{};
  [[nodiscard]] bool blank() const { return values == decltype(values){}; }
  friend bool operator==(const Gist&, const Gist&) = default;
};
static_assert(sizeof(Gist) == kGistValues);

/// Of the values as a vector: their root mean square is 40 then, and only what is above six times
/// that is cut off
inline constexpr double kGistLength = 784.0;

/// Distance of two gists on the sphere of unit length: 0 for the same image, about 0.3 for a step
/// to the side, at most sqrt(2); that where one of them is blank.
[[nodiscard]] double gist_distance(const Gist& a, const Gist& b);

/// The gist of images, after Oliva and Torralba (2001), "Modeling the shape of the scene": energies
/// of oriented filters at several scales, averaged over a coarse grid. The filters are V1's complex
/// cells (Rodrigues and du Buf 2006); the paper names global gist among what they are to serve.
/// Ours is the compression (the square root of a response, between the response and its logarithm)
/// and that nothing is learned: there are no principal components, so that a gist means the same in
/// every building. Integer arithmetic up to the last step, whose operations are exactly rounded:
/// the same bits on every instruction set. Keeps its buffers.
class GistFinder {
 public:
  GistFinder();

  /// @param grey any size; its sides are taken as 4 : 3. Empty throws std::invalid_argument.
  [[nodiscard]] Gist find(const cv::Mat1b& grey);

 private:
  void pool(int scale);

  V1Cells cells_;
  std::vector<std::int32_t> root_;  ///< of each code, the root of its response in 1/256
  std::array<cv::Mat1b, kGistScales> images_;
  V1Responses responses_;
  std::array<std::int64_t, kGistValues> pooled_{};
};

}  // namespace striate::perception
