#pragma once

#include <vector>

#include "striate/perception/corridor/edge_points.hpp"

namespace striate::perception {

/// The search for where the corridor's edges converge: on the horizon's row, near it at least.
struct VanishingSearch {
  double horizon_v_px = 0.0;  ///< row of the horizon
  double from_u_px = 0.0;     ///< columns searched, may lie outside the image
  double to_u_px = 0.0;
  std::vector<double> also_u_px;  ///< places to judge whatever the edges vote for
};

struct VanishingPoint {
  double u_px = 0.0;
  double v_px = 0.0;         ///< close to the horizon's row
  double lines_left = 0.0;   ///< length in px of the lines that converge here from the left
  double lines_right = 0.0;  ///< and from the right
  int lines = 0;             ///< how many different lines
  double spread_px = 0.0;    ///< mean distance at which these lines miss the point
  double score = 0.0;        ///< sum of squared lengths of the lines through it
};

/// Skirtings, ceiling lines, lamp rows and rows of bricks all point to one place. Every edge point
/// votes for where its line crosses the horizon, as sharply as its orientation allows; the best
/// candidates are judged by how much edge lies on long lines through them; each is then moved to
/// the least-squares meeting point of its lines, held near the horizon. Upright edges do not vote.
/// @return distinct places, best first; empty where nothing converges.
[[nodiscard]] std::vector<VanishingPoint> find_vanishing_points(const std::vector<EdgePoint>& edges,
                                                                const VanishingSearch& search);

}  // namespace striate::perception
