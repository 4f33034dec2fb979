#pragma once

#include "config/settings.hpp"

namespace striate {

/// Keypoints of one scale.
struct KeypointSettings {
  double wavelength_px = 8.0;  ///< lambda, in the picture that is handed in
  bool halve = true;           ///< lambda / 2 on the picture at half its size: the same up to blur
  double inhibition = 1.0;     ///< g: weight of tangential and radial inhibition
  double radial_factor = 4.0;  ///< k of the original model's radial inhibition
  double threshold = 0.04;     ///< of the picture's largest response
  int most = 1000;             ///< the strongest so many are kept
};

template <class V>
void visit(V& v, KeypointSettings& s) {
  using config::Unit;
  v.number("wavelength", s.wavelength_px, Unit::pixels, {4.0, 24.0}, "of the V1 cells");
  v.flag("halve", s.halve, "use half the wavelength on the picture at half its size");
  v.number("inhibition", s.inhibition, Unit::none, {0.0, 4.0}, "weight of inhibition along lines");
  v.number("radial_factor", s.radial_factor, Unit::none, {0.0, 16.0}, "of crossing responses");
  v.number("threshold", s.threshold, Unit::fraction, {0.0, 1.0}, "of the largest response");
  v.integer("most", s.most, {1, 100000}, "the strongest so many keypoints are kept");
}

}  // namespace striate
