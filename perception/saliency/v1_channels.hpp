#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "perception/v1/v1_cells.hpp"

namespace striate {

/// Complex-cell responses of 8 orientations in grey levels, at half the working size.
using OrientedEnergy = std::array<cv::Mat1f, kOrientations>;

/// The mean of 2x2 complex responses of `v1`, divided by its gain. `out` keeps its buffers.
void average_energy(const V1Responses& v1, cv::Size half, OrientedEnergy& out);

/// Texture: where the energy of an orientation differs from that of the surround,
///   sum_i |G(sigma) * C_i - G(3 sigma) * C_i|.
/// Ours; the paper names texture as future work. Adds to `sum`; `sigma_px` at this size.
void add_texture(const OrientedEnergy& energy, double sigma_px, cv::Mat1f& sum);

/// Shape: a point that contours of several orientations surround, each facing its partner on the
/// other side, as those of a compact thing do around its middle:
///   sum_i min(C_i(p + r n_i), C_i(p - r n_i)),  n_i = (cos theta_i, sin theta_i).
/// Ours. Beyond the picture the response is zero. Adds to `sum`; `radius_px` at this size.
void add_shape(const OrientedEnergy& energy, double radius_px, cv::Mat1f& sum);

}  // namespace striate
