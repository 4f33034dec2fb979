#pragma once

#include <algorithm>

#include "striate/config/settings.hpp"
#include "striate/perception/v1/v1_settings.hpp"

namespace striate::perception {

/// paper: what the paper says, to the letter. robust: what works best here.
enum class StereoMode { paper, robust };

/// What the number that comes with a disparity means.
enum class StereoConfidence {
  score,    ///< orders disparities; where it is low, it promises less than it keeps
  promise,  ///< calibrated: of the disparities with 0.9, 90 % are right within 1 px
};

/// How the robust setting decides; the paper's setting has none of this.
struct RobustStereoSettings {
  /// A shorter wavelength than the paper's 4 px and a narrow, round envelope: finer in the
  /// image, and exactly separable, so also faster.
  V1Settings v1{3.0, 0.30, 1.0, EvenMean::envelope};
  /// P1, in bits: neighbours differ by one px; chosen on the stereo pairs (tests/evaluation)
  int small_step_penalty = 20;
  /// P2, in bits: by more; chosen on the stereo pairs (tests/evaluation)
  int large_step_penalty = 80;
  int left_right_px = 1;  ///< tolerance of the left-right check: rounding of either side
  StereoConfidence confidence = StereoConfidence::promise;
  /// In that measure; less certain ones are unknown: bad-2 3.5 at 94 % (tests/evaluation)
  double least_confidence = 0.5;
  /// Connected pieces smaller than this are dropped: without, bad-2 was 4.5 (tests/evaluation)
  int speckle_px = 40;
  /// Gaps up to this long are filled, at width 160; between 8 and 12 as tried (tests/evaluation)
  int fill_gap_px = 10;
  bool fine_greys = true;  ///< see StereoSettings::wants_fine_greys
  /// Rows that the eyes show at different heights are measured and moved (row_offset.hpp).
  bool align_rows = true;
};

/// Settings of StereoMatcher.
struct StereoSettings {
  StereoMode mode = StereoMode::robust;
  int width = 160;  ///< px; images are brought to this width: the paper's, section on stereo
  /// Disparities searched; 0: 150 (paper), 64 (robust, 0.38 m) at width 160, in scale
  int candidates = 0;
  V1Settings paper_v1;  ///< of the paper setting: lambda = 4 px
  RobustStereoSettings robust;

  /// Working images in sixteenths of a grey level (to_fine_working_size): averaging many pixels
  /// leaves more than 8 bits hold, and on blank surfaces it is all there is. Always so in the
  /// paper setting, whose images are numbers, not bytes.
  [[nodiscard]] bool wants_fine_greys() const {
    return mode == StereoMode::paper || robust.fine_greys;
  }
  /// Disparities 0 .. n - 1 are searched; at most 256.
  [[nodiscard]] int searched() const {
    if (candidates > 0) return candidates;
    const int at_160 = mode == StereoMode::paper ? 150 : 64;
    return std::clamp(at_160 * width / 160, 1, 256);
  }
};

template <class V>
void visit(V& v, RobustStereoSettings& s) {
  using config::Unit;
  v.section("v1", s.v1);
  v.integer("small_step_penalty", s.small_step_penalty, {0, 120}, "bits, for a step of one pixel");
  v.integer("large_step_penalty", s.large_step_penalty, {1, 120}, "bits, for a larger step");
  v.integer("left_right", s.left_right_px, {0, 8}, "pixels that left and right may disagree by");
  v.choice("confidence", s.confidence, {"score", "promise"},
           "of a disparity: the bare score, or calibrated (a share that is right)");
  v.number("least_confidence", s.least_confidence, Unit::fraction, {0.0, 1.0},
           "less certain disparities are unknown");
  v.integer("speckle", s.speckle_px, {0, 2000}, "smaller connected pieces are dropped, pixels");
  v.integer("fill_gap", s.fill_gap_px, {0, 100},
            "longest gap that neighbours fill, pixels at width 160; 0: none is filled");
  v.flag("fine_greys", s.fine_greys, "keep sixteenths of a grey level of the working images");
  v.flag("align_rows", s.align_rows,
         "move the right image's rows where the eyes show them at different heights");
}

template <class V>
void visit(V& v, StereoSettings& s) {
  v.renamed("setting", "mode");
  v.choice("mode", s.mode, {"paper", "robust"}, "the paper's stereo, or the best we have");
  v.integer("width", s.width, {32, 640}, "working width, pixels");
  v.integer("candidates", s.candidates, {0, 256},
            "disparities searched; 0: 150 (paper) or 64 (robust) at width 160");
  v.section("paper_v1", s.paper_v1);
  v.section("robust", s.robust);
}

}  // namespace striate::perception
