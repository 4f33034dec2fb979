#pragma once

#include <array>
#include <cstdint>

#include "striate/perception/keypoints/end_stopped_kernels.hpp"
#include "striate/perception/keypoints/keypoint_settings.hpp"
#include "striate/perception/v1/v1_cells.hpp"

namespace striate::perception {

/// A place between pixels: four neighbours and their bilinear weights in 1/32768.
struct Sample {
  int du = 0;
  int dv = 0;
  std::array<std::uint16_t, 4> weights{};  ///< of (0, 0), (1, 0), (0, 1), (1, 1) from there
};

/// A factor as a fraction of 2^16 and saturating doublings: value * 2^doublings / 65536.
struct FixedFactor {
  std::uint16_t fraction = 0;
  int doublings = 0;
};
[[nodiscard]] FixedFactor fixed_factor(double factor);

/// Where the end-stopped cells of each orientation look; d = 0.6 lambda.
struct EndStoppedGeometry {
  struct Places {
    std::array<Sample, 2> double_;     ///< (+-2d s, -+2d c)
    std::array<Sample, 2> tangential;  ///< (+-d c, +-d s)
    std::array<Sample, 2> radial;      ///< (+-d/2 c, +-d/2 s), on the orthogonal orientation
    std::array<Sample, 2> single;      ///< (+-d s, -+d c)
  };
  std::array<Places, kOrientations> places;
  FixedFactor inhibition;     ///< g
  FixedFactor radial_factor;  ///< k
  bool single_stopped = false;
  int reach = 0;  ///< pixels that the responses must be known beyond the border
};

[[nodiscard]] EndStoppedGeometry end_stopped_geometry(double wavelength_px,
                                                      const KeypointSettings& settings);

/// End-stopped cells with tangential and radial inhibition (Rodrigues and du Buf 2006, 2009;
/// Terzic, Rodrigues and du Buf 2013):
///   K = [ sum D_i - g (I_T + I_R) ]+   or with the larger of sum S_i and sum D_i.
/// In 16-bit integers, sums saturating, so that every instruction set gives the same bits. Works
/// down the image row by row; the few rows that it looks at stay in the cache.
class EndStoppedCells {
 public:
  EndStoppedCells(double wavelength_px, const KeypointSettings& settings);

  /// How far beyond the border the responses must be continued, in pixels.
  [[nodiscard]] int reach() const { return geometry_.reach; }

  /// @param out K in half units of the simple cells' 16-bit responses, 0..65535.
  void respond(const V1Responses& responses, Plane<std::uint16_t>& out);

 private:
  void take_row(const V1Responses& responses, int y);
  [[nodiscard]] const std::uint16_t* ring_row(std::size_t orientation, int y) const;
  end_stopped_kernels::Tap tap(std::size_t orientation, const Sample& sample, int y) const;
  void look_from_row(int y);

  EndStoppedGeometry geometry_;
  std::array<Plane<std::uint16_t>, kOrientations> rings_;  ///< C_i of the last 2 reach + 1 rows
  end_stopped_kernels::RowJob job_;
};

}  // namespace striate::perception
