#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "striate/perception/v1/v1_cells.hpp"

namespace striate::perception {

/// Complex-cell responses of 8 orientations in grey levels, at a quarter of the working size.
using OrientedEnergy = std::array<cv::Mat1f, kOrientations>;

/// A quarter of the working size, rounded up.
[[nodiscard]] cv::Size quarter_of(cv::Size working);

/// The V1 channels of salience. Ours: the paper names texture and shape as future work. Keeps its
/// buffers. All lengths are in px of the quarter-size planes; beyond the image they are mirrored,
/// so that no place is preferred (see README). The energies are sums of integers and so the same
/// bits on every instruction set.
class V1Channels {
 public:
  /// energy_i(block) = mean of the complex responses C_i over blocks of 4x4 px, in grey levels.
  void average(const V1Responses& v1);

  /// Texture: where an orientation has more energy than around,
  ///   sum over i and sigma in {1, 2} of max(0, G(sigma) * C_i - G(3 sigma) * C_i).
  void texture(cv::Mat1f& out);

  /// Shape: a point that contours of several orientations surround, each facing its partner on the
  /// other side, as those of a compact thing do around its middle:
  ///   sum over i and r in {2, 4, 6} of min(C_i(p + r n_i), C_i(p - r n_i)),
  ///   n_i = (cos theta_i, sin theta_i), r n_i rounded to whole px.
  void shape(cv::Mat1f& out) const;

  [[nodiscard]] const OrientedEnergy& energy() const { return energy_; }

 private:
  OrientedEnergy energy_;
  std::vector<std::uint16_t> amplitudes_;
  std::vector<std::uint32_t> sums_;
  cv::Mat all_, narrow_, wide_;  ///< CV_32FC(8): one pixel, its orientations
};

}  // namespace striate::perception
