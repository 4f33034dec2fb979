#pragma once

#include <vector>

#include "striate/perception/obstacles/view_geometry.hpp"

namespace striate::perception {

/// An upright plane as stereo sees it: its level disparity is linear in u, and the column where
/// that line reaches zero is the plane's vanishing point on the horizon.
struct UprightPlane {
  double vanishing_u_px = 0.0;
  double share = 0.0;    ///< of the sampled pixels that lie on it, 0..1
  double along_m = 0.0;  ///< length over which it shows
};

/// The strongest upright planes that are seen at a slant, by RANSAC over trusted pixels above the
/// floor; at most two, the second among what the first leaves. Planes square to the camera vanish
/// outside `reach_px` from the image's middle and are left out. Deterministic.
[[nodiscard]] std::vector<UprightPlane> find_upright_planes(const DisparityMap& map,
                                                            const ViewGeometry& geometry,
                                                            double reach_px);

}  // namespace striate::perception
