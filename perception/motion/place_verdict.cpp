#include "striate/perception/motion/place_verdict.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "striate/base/index_within.hpp"

namespace striate::perception {
namespace {

/// What is measured around a place, against what would be measured if the thing were there.
enum class Around { unknown, same, farther, nearer, mixed };

Around look_around(const DisparityMap& map, const ImagePoint& place, const MotionSettings& s) {
  const int u = nearest_cell(place.u_px);
  const int v = nearest_cell(place.v_px);
  const int r = s.slack_px;
  const cv::Mat1f& d = map.disparity_px;
  if (u < r || v < r || u >= d.cols - r || v >= d.rows - r) return Around::unknown;
  const double tolerance = std::max(s.tolerance_px, s.tolerance * place.d_px);
  int farther = 0;
  int nearer = 0;
  for (int y = v - r; y <= v + r; ++y) {
    for (int x = u - r; x <= u + r; ++x) {
      if (!std::isfinite(d(y, x)) || map.confidence(y, x) < s.trusted) continue;
      const double by_px = d(y, x) - place.d_px;
      if (std::abs(by_px) <= tolerance) return Around::same;
      ++(by_px > 0.0 ? nearer : farther);
    }
  }
  if (2 * (farther + nearer) <= (2 * r + 1) * (2 * r + 1)) return Around::unknown;
  if (farther > 0 && nearer > 0) return Around::mixed;
  return farther > 0 ? Around::farther : Around::nearer;
}

/// Whether what stood before at `place`, nearer than the point that is seen now, stands there no
/// more, and was no farther from the point than it could have walked.
bool has_left(const SpacePoint& point, const ImagePoint& place, const CarriedBack& carried,
              const SeenMaps& maps, const MotionSettings& s) {
  const cv::Point at(nearest_cell(place.u_px), nearest_cell(place.v_px));
  const float d = maps.before.disparity_px(at);
  if (!std::isfinite(d) || maps.before.confidence(at) < s.trusted) return false;
  const SpacePoint stood = carried.before().point(at.x, at.y, d);
  const Point2 floor = carried.to_now({stood.x_m, stood.y_m});
  const double walked_m = std::hypot(point.x_m - floor.x_m, point.y_m - floor.y_m);
  if (walked_m > s.fastest_m_s * maps.seconds) return false;
  const std::optional<ImagePoint> now = carried.now().project({floor.x_m, floor.y_m, stood.z_m});
  return now && look_around(maps.now, *now, s) == Around::farther;
}

}  // namespace

Verdict judge_point(const SpacePoint& point, const CarriedBack& carried, const SeenMaps& maps,
                    const MotionSettings& settings) {
  const std::optional<ImagePoint> place = carried(point);
  if (!place) return Verdict::unknown;
  switch (look_around(maps.before, *place, settings)) {
    case Around::same:
      return Verdict::stayed;
    case Around::farther:
      return Verdict::came;
    case Around::nearer:
      return has_left(point, *place, carried, maps, settings) ? Verdict::went : Verdict::unknown;
    default:
      return Verdict::unknown;
  }
}

}  // namespace striate::perception
