#include "striate/memory/localisation/route_learner.hpp"

#include <algorithm>
#include <cmath>

namespace striate::memory {
namespace {

constexpr double kSeenWithin_m = 6.0;  // by hand, of way: longer unseen, it may be another
constexpr double kFartherBy_m = 0.5;   // by hand: than at its nearest, or nearer again
constexpr int kWitnesses = 3;  ///< by hand, looks: what was seen once or twice may be another thing
constexpr double kAgainAfter_m = 1.5;  ///< by hand, of way: sooner, it is the same pass

}  // namespace

void RouteLearner::move(const SlamEstimate& estimate, std::vector<Station>& passed) {
  passed.clear();
  const Pose2 pose = estimate.pose();
  const double way_m = estimate.way_m();
  const auto landmarks = estimate.landmarks();
  for (std::size_t k = 0; k < std::min(landmarks.size(), nearest_.size()); ++k) {
    Nearest& nearest = nearest_[k];
    if (landmarks[k].number < 0) {
      nearest.approached = false;
      continue;
    }
    const std::optional<MapPosition> place = estimate.place(landmarks[k]);
    const double distance_m = std::hypot(place->x_m - pose.x_m, place->y_m - pose.y_m);
    const bool counts = landmarks[k].taken >= kWitnesses && distance_m <= settings_.pass_within_m &&
                        way_m - landmarks[k].seen_at_m <= kSeenWithin_m &&
                        way_m - nearest.left_at_m >= kAgainAfter_m;
    // Driving away from it is no approach.
    nearest.farthest_m = std::max(nearest.farthest_m, distance_m);
    const bool nears = nearest.approached ? distance_m < nearest.distance_m
                                          : distance_m < nearest.farthest_m - kFartherBy_m;
    if (counts && nears) {
      nearest = {true, distance_m, way_m, estimate.odometry().heading_rad, nearest.left_at_m};
    }
    if (!nearest.approached || distance_m < nearest.distance_m + kFartherBy_m) continue;
    passed.push_back({landmarks[k].landmark, nearest.way_m, nearest.heading_rad});
    nearest.approached = false;
    nearest.left_at_m = way_m;
    nearest.farthest_m = distance_m;
  }
  std::sort(passed.begin(), passed.end(),
            [](const Station& a, const Station& b) { return a.way_m < b.way_m; });
}

}  // namespace striate::memory
