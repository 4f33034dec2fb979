#pragma once

#include <array>

#include "perception/v1/v1_cells.hpp"

namespace striate {

/// Complex responses C_i as numbers, continued beyond the border like their codes.
using ComplexPlanes = std::array<Plane<float>, kOrientations>;

/// A place between pixels: four neighbours and their weights.
struct Sample {
  int du = 0;
  int dv = 0;
  std::array<float, 4> weights{};  ///< of (0, 0), (1, 0), (0, 1), (1, 1) from there
};

/// Where the end-stopped cells of each orientation look; d = 0.6 lambda. Bilinear between pixels.
struct EndStoppedGeometry {
  struct Places {
    std::array<Sample, 2> single;      ///< (+-d s, -+d c)
    std::array<Sample, 2> double_;     ///< (+-2d s, -+2d c)
    std::array<Sample, 2> tangential;  ///< (+-d c, +-d s)
    std::array<Sample, 2> radial;      ///< (+-d/2 c, +-d/2 s), on the orthogonal orientation
  };
  std::array<Places, kOrientations> places;
  float inhibition = 1.0F;
  float radial_factor = 4.0F;
  int reach = 0;  ///< pixels that the planes must be readable beyond the border
};

[[nodiscard]] EndStoppedGeometry end_stopped_geometry(double wavelength_px, double inhibition,
                                                      double radial_factor);

void complex_planes(const V1Responses& responses, ComplexPlanes& out);

/// K = max(sum S_i, sum D_i) - g (I_T + I_R) at every pixel; vectorised, multiplication and
/// addition apart, so that every instruction set gives the same bits.
void end_stopped_response(const ComplexPlanes& complex, const EndStoppedGeometry& geometry,
                          Plane<float>& out);

}  // namespace striate
