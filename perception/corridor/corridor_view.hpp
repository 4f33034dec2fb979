#pragma once

#include <opencv2/core/mat.hpp>

#include "striate/config/settings.hpp"
#include "striate/perception/percept.hpp"
#include "striate/platform/interface/robot.hpp"
#include "striate/platform/interface/senses.hpp"

namespace striate::perception {

struct CorridorSettings {
  /// 40 deg: planes say less and less up to here; the image's own edge is at 21.5 deg
  double widest_rad = 0.70;
  double least_confidence = 0.3;  ///< above what edges alone have that also point elsewhere (0.255)
};

template <class V>
void visit(V& v, CorridorSettings& s) {
  using config::Unit;
  v.number("widest", s.widest_rad, Unit::angle, {0.1, 1.2},
           "largest angle between the camera's axis and the corridor's");
  v.number("least_confidence", s.least_confidence, Unit::fraction, {0.0, 1.0},
           "below, no corridor is claimed");
}

/// The corridor as one image shows it: its heading from where long straight edges converge on
/// the horizon (which works along blank walls), checked and completed by the walls that stereo
/// sees: of several places where edges converge, the one along which most wall stands wins.
/// `grey` is the left image at any size of the same aspect as `map`; `map` may hold no disparity
/// (one-eyed), then no wall has a distance.
[[nodiscard]] CorridorView view_corridor(const cv::Mat1b& grey, const DisparityMap& map,
                                         const HeadPose& head, const RobotDescription& robot,
                                         const CorridorSettings& settings);

}  // namespace striate::perception
