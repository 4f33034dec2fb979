#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "striate/perception/keypoints/end_stopped.hpp"

/// What the end-stopped cells must give, written plainly.
namespace striate::reference {

/// K by the formula, in double precision, from the codes of the complex cells; in half units, as
/// EndStoppedCells::respond.
inline double end_stopped_exact(const perception::V1Responses& responses,
                                const perception::KeypointSettings& settings, int u, int v) {
  auto at = [&](std::size_t i, double x, double y) {
    const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
    const double a = x - left, b = y - top;
    auto pixel = [&](int du, int dv) {
      return 0.5 * perception::complex_response(responses.code[i].row(top + dv)[left + du]);
    };
    return (1 - b) * ((1 - a) * pixel(0, 0) + a * pixel(1, 0)) +
           b * ((1 - a) * pixel(0, 1) + a * pixel(1, 1));
  };
  auto positive = [](double value) { return std::max(0.0, value); };
  const double d = 0.6 * responses.wavelength_px;
  double single = 0.0, twice = 0.0, inhibition = 0.0;
  for (std::size_t i = 0; i < perception::kOrientations; ++i) {
    const double c =
        std::cos(static_cast<double>(i) * std::numbers::pi / perception::kOrientations);
    const double s =
        std::sin(static_cast<double>(i) * std::numbers::pi / perception::kOrientations);
    const double here = at(i, u, v);
    single += positive(at(i, u + d * s, v - d * c) - at(i, u - d * s, v + d * c));
    twice += positive(here - 0.5 * at(i, u + 2 * d * s, v - 2 * d * c) -
                      0.5 * at(i, u - 2 * d * s, v + 2 * d * c));
    for (const double sign : {-1.0, 1.0}) {
      inhibition += positive(at(i, u + sign * d * c, v + sign * d * s) - here);
      inhibition +=
          positive(here - settings.radial_factor *
                              at((i + perception::kOrientations / 2) % perception::kOrientations,
                                 u + sign * d / 2 * c, v + sign * d / 2 * s));
    }
  }
  const bool both = settings.response == perception::EndStoppedResponse::largest;
  return positive((both ? std::max(single, twice) : twice) - settings.inhibition * inhibition);
}

/// The integer algorithm: every instruction set must give exactly this.
inline int end_stopped_integer(const perception::V1Responses& responses,
                               const perception::EndStoppedGeometry& geometry, int u, int v) {
  auto amplitude = [&](std::size_t i, int x, int y) {
    return static_cast<int>(perception::complex_response(responses.code[i].row(y)[x]) + 0.5F);
  };
  auto look = [&](std::size_t i, const perception::Sample& sample) {
    int sum = 2;
    for (int k = 0; k < 4; ++k) {
      const int value = amplitude(i, u + sample.du + k % 2, v + sample.dv + k / 2);
      sum += value * sample.weights[static_cast<std::size_t>(k)] / 65536;
    }
    return sum;
  };
  auto doubled = [](int value, int times) { return std::min(value, 0xFFFF >> times) << times; };
  auto add_positive = [](int& sum, int value) { sum = std::min(0xFFFF, sum + std::max(0, value)); };
  int single = 0, twice = 0, inhibited = 0;
  for (std::size_t i = 0; i < perception::kOrientations; ++i) {
    const perception::EndStoppedGeometry::Places& p = geometry.places[i];
    const int centre = amplitude(i, u, v) / 2;
    add_positive(single, look(i, p.single[0]) - look(i, p.single[1]));
    add_positive(twice, centre - (look(i, p.double_[0]) + look(i, p.double_[1])) / 2);
    for (std::size_t side = 0; side < 2; ++side) {
      const std::size_t crossing = (i + perception::kOrientations / 2) % perception::kOrientations;
      add_positive(inhibited, look(i, p.tangential[side]) - centre);
      add_positive(inhibited, centre - doubled(look(crossing, p.radial[side]),
                                               geometry.radial_factor.doublings));
    }
  }
  const int excited = geometry.single_stopped ? std::max(single, twice) : twice;
  const auto less =
      static_cast<int>(std::int64_t{inhibited} * geometry.inhibition.fraction / 65536);
  return std::max(0, excited - doubled(less, geometry.inhibition.doublings));
}

}  // namespace striate::reference
