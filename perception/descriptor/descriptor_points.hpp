#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace striate::perception {

inline constexpr int kDescriptorPoints = 32;  ///< on 4 circles; paper, section on the descriptor
/// 32 points x 8 orientations; paper, section on the descriptor
inline constexpr int kDescriptorBits = 256;

/// A point of the descriptor relative to its centre, in whole pixels (u right, v down).
struct DescriptorPoint {
  int du = 0;
  int dv = 0;
};

/// The paper's descriptor compares the centre with 32 points on 4 circles of radius 0.2, 0.45,
/// 0.75 and 1.0 lambda; 4, 6, 9 and 13 points, every circle starting on +u and turning towards +v.
/// Points are taken at the nearest pixel (halves towards +u, +v): the paper names no
/// interpolation.
/// @param widening factor of all radii; 1 is the paper's.
[[nodiscard]] inline std::array<DescriptorPoint, kDescriptorPoints> descriptor_points(
    double wavelength_px, double widening) {
  /// Of lambda; paper, section on the descriptor
  constexpr std::array<double, 4> kRadius = {0.2, 0.45, 0.75, 1.0};
  /// Points a circle; the paper says 32 in all, the group's program 4, 6, 9 and 13
  constexpr std::array<int, 4> kCount = {4, 6, 9, 13};
  // Without the nudge, 3 cos(120 deg) = -1.4999999999999993 depends on the mathematics library.
  auto nearest = [](double value) { return static_cast<int>(std::floor(value + 0.5 + 1e-9)); };
  std::array<DescriptorPoint, kDescriptorPoints> points{};
  std::size_t at = 0;
  for (std::size_t circle = 0; circle < kRadius.size(); ++circle) {
    for (int k = 0; k < kCount[circle]; ++k) {
      const double radius = kRadius[circle] * wavelength_px * widening;
      const double angle = 2.0 * std::numbers::pi * k / kCount[circle];
      points[at++] = {nearest(radius * std::cos(angle)), nearest(radius * std::sin(angle))};
    }
  }
  return points;
}

/// How far the points reach from the centre, in pixels.
[[nodiscard]] inline int descriptor_reach(double wavelength_px, double widening) {
  return static_cast<int>(std::ceil(wavelength_px * widening)) + 1;
}

}  // namespace striate::perception
