#pragma once

#include <array>
#include <cstdint>

#include "striate/perception/v1/v1_settings.hpp"

/// The vector code of EndStoppedCells, dispatched at run time; 16-bit integers throughout.
namespace striate::perception::end_stopped_kernels {

/// C_i from its code (see complex_response), to the nearest whole number.
void amplitudes(const std::int16_t* code, int count, std::uint16_t* out);

/// Four neighbours of a place between pixels; each weight stands twice, in both halves.
struct Tap {
  const std::uint16_t* upper = nullptr;  ///< for column 0; its right neighbour follows
  const std::uint16_t* lower = nullptr;
  std::array<std::uint32_t, 4> weights{};
};

struct OrientationTaps {
  const std::uint16_t* centre = nullptr;
  std::array<Tap, 2> double_, tangential, radial, single;
};

/// One row of K; see EndStoppedGeometry for the factors.
struct RowJob {
  std::array<OrientationTaps, kOrientations> taps;
  int radial_doublings = 0;
  std::uint16_t inhibition = 0;
  int inhibition_doublings = 0;
  bool single_stopped = false;
};
void respond_row(const RowJob& job, int width, std::uint16_t* out);

}  // namespace striate::perception::end_stopped_kernels
