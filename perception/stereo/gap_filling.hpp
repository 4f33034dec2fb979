#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "striate/perception/percept.hpp"

namespace striate::perception {

/// What a pixel in a small gap is filled from.
enum class GapKind {
  surface,  ///< both ends belong to one surface: a straight line between them
  step,     ///< they do not: the farther one goes on behind the nearer one
  border,   ///< the gap ends at the image's border: its one end goes on
};

/// How often what is filled in is right: by GapKind, and by the gap's length, at most a third, two
/// thirds and all of the longest that is filled. It hardly depends on how sure the ends are, but
/// no filled pixel is surer than they.
using GapTrust = std::array<std::array<float, 3>, 3>;

/// Measured by `confidence_fit` (tests/evaluation) on made scenes, none of which is evaluated; of
/// 160x120 and 320x240 the lower.
inline constexpr GapTrust kGapTrust = {{
    {0.75F, 0.79F, 0.79F},
    {0.60F, 0.51F, 0.42F},
    {0.53F, 0.43F, 0.43F},
}};

struct GapSettings {
  int longest_px = 0;             ///< 0: nothing is filled
  float least_confidence = 0.0F;  ///< nor what would have less
};

/// Closes small gaps between known disparities. A pixel is in a gap of its row if the unknown
/// pixels between the nearest known ones (or the border) to its left and right are at most
/// `longest_px`; likewise of its column. Of both the one with ends on one surface is taken, else
/// the shorter one. Larger gaps stay: a blank wall is not invented. Keeps its buffers.
class GapFilling {
 public:
  explicit GapFilling(const GapTrust& trust = kGapTrust) : trust_(trust) {}

  void fill(const GapSettings& settings, DisparityMap& map);

 private:
  void measure_columns();
  void measure_row(int y);

  GapTrust trust_;
  cv::Mat1f disparity_px_, confidence_;  ///< before anything is filled
  /// Nearest known pixel of the same column (a row's number) and row (a column's); -1: none up or
  /// left, the height or width: none down or right.
  cv::Mat1i up_, down_;
  std::vector<int> left_, right_;
};

}  // namespace striate::perception
