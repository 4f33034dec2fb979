#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace striate {

/// What `striate perceive` is asked: one picture pair, any pair, and where the answers go.
struct PerceiveOptions {
  std::filesystem::path left;
  std::filesystem::path right;        ///< empty: one eye; saliency, keypoints and overview only
  std::filesystem::path out;          ///< folder; made where missing
  std::string setting = "robust";     ///< or "paper"
  int width_px = 160;                 ///< working width; the paper's
  int candidates = 0;                 ///< disparities searched; 0: 150 at width 160, in scale
  double focal_px = 0.0;              ///< of the pictures as they are in the files; 0: unknown
  double baseline_m = 0.0;            ///< 0: unknown, and no distances are told
  std::optional<double> centre_u_px;  ///< principal point; the picture's middle where not given
  std::optional<double> centre_v_px;
  std::optional<double> camera_height_m;  ///< above the floor; unknown: near blobs are obstacles
  double tilt_deg = 0.0;                  ///< up positive; counts where the height is known
  double near_px = 0.0;  ///< threshold of near blobs, px at working size; 0: from the picture
};

/// Writes into `options.out`: disparity.pfm and confidence.pfm (float, working size, left frame,
/// bottom row first, little-endian; +inf is no trusted match), obstacles.json, saliency.png,
/// keypoints.json and overview.png. Pictures may be grey or colour, 8 or 16 bit, with alpha.
/// Returns 0. Throws UserError for pictures that cannot be used and for impossible options,
/// std::runtime_error where `out` cannot be written.
int perceive(const PerceiveOptions& options);

}  // namespace striate
