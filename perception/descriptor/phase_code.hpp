#pragma once

#include <array>
#include <cstdint>

#include "striate/perception/descriptor/descriptor_points.hpp"
#include "striate/perception/v1/v1_cells.hpp"

namespace striate::perception {

/// Comparisons a phase, each a bit of 8 orientations: eighths of a turn need 4
inline constexpr int kPhaseBytes = 4;

/// Where the 8 phase codes of a descriptor are taken, around its centre.
inline constexpr std::array<DescriptorPoint, 8> kPhasePoints = {
    {{0, -2}, {-1, -1}, {1, -1}, {-2, 0}, {2, 0}, {-1, 1}, {1, 1}, {0, 2}}};
inline constexpr int kPhaseReach = 2;  ///< px: how far kPhasePoints lie from the centre

/// The local phase of the simple cells, atan2(odd, even) in eighths of a turn, as 4 bits per
/// orientation: odd > 0, even > 0, even > odd, even > -odd. Neighbouring eighths differ in one bit
/// and opposite ones in four, so the Hamming distance measures the difference of phase. The codes
/// of 8 orientations at 8 points make a descriptor of 256 bits.
///
/// Ours: the paper's descriptor compares energies, which know no phase; phase tells edges of
/// different polarity and place apart, and is as indifferent to exposure.
struct PhaseCodes {
  int width = 0;
  int height = 0;
  /// Bit i of plane k at (u, v): comparison k of orientation i. Continued beyond the border by
  /// kPhaseReach rows and by as many columns as were asked for.
  std::array<Plane<std::uint8_t>, kPhaseBytes> bytes;
};

/// @param responses with simple cells.
/// @param margin columns readable beyond the border, besides kPhaseReach.
void phase_codes(const V1Responses& responses, int margin, PhaseCodes& out);

}  // namespace striate::perception
