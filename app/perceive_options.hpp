#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace striate::app {

// By hand: below the least width little is left of the paper's Gabor cells, whose wavelengths are
// of 160 px; beyond the most a pair takes seconds. The stereo searches 256 disparities at most.
inline constexpr int kLeastWidth_px = 32;
inline constexpr int kMostWidth_px = 640;
inline constexpr int kMostCandidates = 256;
/// By hand: of a camera that still sees the floor or the way.
inline constexpr double kMostTilt_deg = 60.0;

/// What `striate perceive` is asked of each image pair, and where the answers go.
struct PerceiveOptions {
  std::filesystem::path left;
  std::filesystem::path right;  ///< empty: one eye; saliency, keypoints and overview only
  std::filesystem::path out;    ///< folder; made where missing
  std::vector<std::filesystem::path> calibration;  ///< of both eyes, or the left's and the right's
  bool rectified = false;  ///< the pictures are rectified already, whatever the calibration is of
  bool exchanged = false;  ///< what is called left is the right eye
  std::string mode = "robust";        ///< or "paper"
  int width_px = 160;                 ///< working width; the paper's
  int candidates = 0;                 ///< disparities searched; 0: 150 at width 160, in scale
  double focal_px = 0.0;              ///< of the images as they are in the files; 0: unknown
  double baseline_m = 0.0;            ///< 0: unknown, and no distances are told
  std::optional<double> centre_u_px;  ///< principal point; the image's middle where not given
  std::optional<double> centre_v_px;
  std::optional<double> right_centre_u_px;  ///< of the right image; the left one's where not given
  std::optional<double> doffs_px;           ///< the same, as Middlebury says it: right less left
  std::optional<double> camera_height_m;    ///< above the floor; unknown: near blobs are obstacles
  double tilt_deg = 0.0;                    ///< up positive; counts where the height is known
  double near_px = 0.0;  ///< threshold of near blobs, px at working size; 0: from the image
};

}  // namespace striate::app
