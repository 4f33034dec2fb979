#pragma once

#include <optional>
#include <vector>

#include "striate/base/geometry.hpp"
#include "striate/memory/long_term/records.hpp"

namespace striate::memory {

/// One landmark on two maps.
struct OnBothMaps {
  MapPosition theirs;
  MapPosition ours;
};

/// Where the origin of their map lies on ours, from landmarks that both know. Nothing where fewer
/// than two lie to each other on one map as on the other, or where most contradict: a landmark that
/// was moved is outvoted.
[[nodiscard]] std::optional<Pose2> align_maps(const std::vector<OnBothMaps>& common);

/// A place of their map on ours.
[[nodiscard]] MapPosition on_our_map(const Pose2& their_origin, const MapPosition& theirs);

}  // namespace striate::memory
