#pragma once

#include "config/settings.hpp"
#include "perception/obstacles/view_geometry.hpp"
#include "perception/percept.hpp"

namespace striate {

struct SaliencySettings {
  double near_px = 6.0;         ///< disparities above count as near
  double near_gain = 1.5;       ///< weight of one px of disparity against one unit of CIE L*
  double least_contrast = 6.0;  ///< a picture whose strongest response is below stays dim
  double threshold = 0.5;       ///< of the salience that regions are cut at
  int smallest_px = 12;         ///< smaller regions are left out
  int most_regions = 12;
};

template <class V>
void visit(V& v, SaliencySettings& s) {
  using config::Unit;
  v.number("near", s.near_px, Unit::pixels, {0.0, 200.0}, "larger disparities count as near");
  v.number("near_gain", s.near_gain, Unit::none, {0.0, 100.0},
           "weight of a pixel of disparity against a unit of CIE L*");
  v.number("least_contrast", s.least_contrast, Unit::none, {0.0, 100.0},
           "response below which a picture stays dim; 0: normalise always, as the paper");
  v.number("threshold", s.threshold, Unit::fraction, {0.05, 0.99}, "salience of a region's border");
  v.integer("smallest", s.smallest_px, {1, 100000}, "least pixels of a region");
  v.integer("most_regions", s.most_regions, {1, 1000}, "regions handed on");
}

/// Salience of a picture at the working size (BGR) and its disparity map, which may be empty.
///
/// Paper, section on saliency: six maps in CIE L*a*b* (L, a, b and their complements), blobs by
/// differences of Gaussians with sigma+ in {5, 10, 20} px and sigma- = 2 sigma+, half-rectified;
/// the same on the disparity thresholded to the near; sum, normalise, threshold. A map and its
/// complement have opposite responses, so their rectified sum is the absolute value: three maps
/// suffice, exactly. Gaussians run on a pyramid; tests hold the result against the direct sum.
/// Deviation: the normalisation has a floor (`least_contrast`), else noise on a blank wall would
/// be as salient as a poster.
[[nodiscard]] SaliencyMap find_salience(const cv::Mat3b& picture, const DisparityMap& map,
                                        const ViewGeometry& geometry,
                                        const SaliencySettings& settings);

}  // namespace striate
