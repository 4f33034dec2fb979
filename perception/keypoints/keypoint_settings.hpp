#pragma once

#include "striate/config/settings.hpp"

namespace striate::perception {

/// Which end-stopped cells make the keypoint response.
enum class EndStoppedResponse {
  double_stopped,  ///< K_D: line ends, corners and blobs
  largest,         ///< max(K_S, K_D), as in the original model
};

/// Keypoints of one or many scales, two per octave.
struct KeypointSettings {
  /// Lambda of the finest scale, in the image that is handed in; the paper's one scale
  double wavelength_px = 8.0;
  bool halve = true;  ///< lambda / 2 on the image at half its size: the same up to blur
  int scales = 1;     ///< wavelength_px * sqrt(2)^k, k = 0 .. scales - 1
  EndStoppedResponse response = EndStoppedResponse::double_stopped;
  /// G: weight of tangential and radial inhibition; the model's 1 repeats less (README)
  double inhibition = 0.25;
  double radial_factor = 4.0;  ///< k of the original model's radial inhibition
  double threshold = 0.04;     ///< of the largest response of its scale; the V1 model's fraction
  double fine_first = 1.0;  ///< responses are divided by (lambda / finest lambda)^this: the larger
                            ///< the cells, the less exact the place
  double apart = 0.4;       ///< wavelengths: of two keypoints that are nearer the stronger stays;
                            ///< only where there are several scales
  int most = 1000;  ///< the strongest so many are kept; as many as are judged (eval keypoints)
};

template <class V>
void visit(V& v, KeypointSettings& s) {
  using config::Unit;
  v.number("wavelength", s.wavelength_px, Unit::pixels, {3.0, 24.0}, "of the V1 cells");
  v.flag("halve", s.halve, "use half the wavelength on the image at half its size");
  v.integer("scales", s.scales, {1, 13}, "two per octave, from 'wavelength' upwards");
  v.choice("response", s.response, {"double_stopped", "largest"},
           "K_D alone or the larger of K_S and K_D");
  v.number("inhibition", s.inhibition, Unit::none, {0.0, 4.0}, "weight of inhibition along lines");
  v.number("radial_factor", s.radial_factor, Unit::none, {0.0, 16.0}, "of crossing responses");
  v.number("threshold", s.threshold, Unit::fraction, {0.0, 1.0}, "of the largest response");
  v.number("fine_first", s.fine_first, Unit::none, {0.0, 4.0},
           "how much fine scales are preferred");
  v.number("apart", s.apart, Unit::none, {0.0, 2.0}, "least distance in wavelengths, over scales");
  v.integer("most", s.most, {1, 100000}, "the strongest so many keypoints are kept");
}

}  // namespace striate::perception
