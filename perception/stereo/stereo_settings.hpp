#pragma once

#include <algorithm>

#include "config/settings.hpp"
#include "perception/v1/v1_settings.hpp"

namespace striate {

/// paper: what the paper says, to the letter. robust: what works best here.
enum class StereoSetting { paper, robust };

/// How the robust setting decides; the paper's setting has none of this.
struct RobustStereoSettings {
  double sigma_factor = 0.30;   ///< of the Gabor envelope: narrower than the published model's
  double gamma = 1.0;           ///< round envelope: exactly separable, so also faster
  double widening = 1.5;        ///< of the descriptor's circles
  int small_step_penalty = 12;  ///< P1, in bits: neighbours differ by one pixel of disparity
  int large_step_penalty = 70;  ///< P2, in bits: by more
  int left_right_px = 1;        ///< tolerance of the left-right check
  double uniqueness = 0.02;     ///< the runner-up must be worse by this fraction
  int speckle_px = 40;          ///< connected pieces smaller than this are dropped
};

/// Settings of StereoMatcher.
struct StereoSettings {
  StereoSetting setting = StereoSetting::robust;
  int width = 160;     ///< px; pictures are brought to this width
  int candidates = 0;  ///< disparities searched; 0: 150 (paper), 64 (robust) at width 160, in scale
  double wavelength_px = 4.0;
  RobustStereoSettings robust;

  /// Disparities 0 .. n - 1 are searched; at most 256.
  [[nodiscard]] int searched() const {
    if (candidates > 0) return candidates;
    const int at_160 = setting == StereoSetting::paper ? 150 : 64;
    return std::clamp(at_160 * width / 160, 1, 256);
  }
};

template <class V>
void visit(V& v, RobustStereoSettings& s) {
  using config::Unit;
  v.number("sigma_factor", s.sigma_factor, Unit::none, {0.2, 1.0}, "envelope sigma / wavelength");
  v.number("gamma", s.gamma, Unit::none, {0.25, 2.0}, "shape of the envelope: factor of y'^2");
  v.number("widening", s.widening, Unit::none, {0.5, 3.0}, "factor of the descriptor's radii");
  v.integer("small_step_penalty", s.small_step_penalty, {0, 120}, "bits, for a step of one pixel");
  v.integer("large_step_penalty", s.large_step_penalty, {1, 120}, "bits, for a larger step");
  v.integer("left_right", s.left_right_px, {0, 8}, "pixels that left and right may disagree by");
  v.number("uniqueness", s.uniqueness, Unit::fraction, {0.0, 1.0},
           "the runner-up must be worse by");
  v.integer("speckle", s.speckle_px, {0, 2000}, "smaller connected pieces are dropped, pixels");
}

template <class V>
void visit(V& v, StereoSettings& s) {
  using config::Unit;
  v.choice("setting", s.setting, {"paper", "robust"}, "the paper's stereo, or the best we have");
  v.integer("width", s.width, {32, 640}, "working width, pixels");
  v.integer("candidates", s.candidates, {0, 256},
            "disparities searched; 0: 150 (paper) or 64 (robust) at width 160");
  v.number("wavelength", s.wavelength_px, Unit::pixels, {3.0, 12.0}, "of the V1 cells");
  v.section("robust", s.robust);
}

}  // namespace striate
