#include "striate/memory/short_term/wall_fit.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace striate::memory {
namespace {

// "By hand": README.md, "Where the numbers come from"; the tests are WallFitter.*.

constexpr double kAhead_m = 5.0;         // by hand: within 5.5 m, beyond which a look says nothing
constexpr double kNearestWall_m = 0.35;  // by hand: a wall this near to the axle is at the flank
constexpr double kBin_m = 0.05;          // a patch of the map, LocalGrid::kCell_m
constexpr int kBins = 56;  // up to 3.15 m: the shipped corridors are 5.0 m wide at most
// Pieces that hold anything are the 64 bits of a number: from -7.5 m to 8.5 m. With kAhead_m and
// the map's half side no place lies farther than 6 m along.
constexpr double kPiece_m = 0.25;
constexpr double kPiecesFrom_m = 7.5;
constexpr double kSolid = 0.7;      // by hand: share of a wall's length that must be there
constexpr float kWallStill = 0.2F;  // as in evidence.cpp: 0 still .. 1 moving
// 9 degrees to each side, more than the gate of CorridorMemory (kHeadingGate_rad, 6.9 degrees).
constexpr int kTurns = 12;
constexpr double kTurn_rad = 0.0131;  // 0.75 degrees: a patch in 3.8 m
// By hand: longer than the things that stand in a corridor, of 24 cells in line: 1.2 m of patches.
constexpr double kLeastLength_m = 1.5;
constexpr double kLeastScore = 24.0;
constexpr std::size_t kMostCells = 4096;    // by hand: a sixteenth of the map
constexpr double kWidthTolerance_m = 0.35;  // as CorridorMemory's kOffsetGate_m

struct Bin {
  float cells = 0.0F;
  float least_m = 1e3F;
  float most_m = -1e3F;
  std::uint64_t pieces = 0;  // quarter metres along it that hold anything
};

// Boxes in a row are no wall: most of a wall's length is there.
bool solid(const Bin& a, const Bin& b, const Bin& c) {
  const int pieces = std::popcount(a.pieces | b.pieces | c.pieces);
  const float length_m =
      std::max({a.most_m, b.most_m, c.most_m}) - std::min({a.least_m, b.least_m, c.least_m});
  return static_cast<double>(pieces) * kPiece_m > kSolid * static_cast<double>(length_m);
}

bool still_thing(const LocalGrid& grid, GridCell cell) {
  return grid.state(cell) == CellState::occupied && grid.moving(cell) <= kWallStill;
}

bool edge_of_floor(const LocalGrid& grid, GridCell cell) {
  if (grid.state(cell) == CellState::free) return false;
  return grid.state({cell.x + 1, cell.y}) == CellState::free ||
         grid.state({cell.x - 1, cell.y}) == CellState::free ||
         grid.state({cell.x, cell.y + 1}) == CellState::free ||
         grid.state({cell.x, cell.y - 1}) == CellState::free;
}

}  // namespace

WallFitter::WallFitter() {
  standing_.reserve(kMostCells);
}

void WallFitter::gather(From from, const LocalGrid& grid, const Pose2& robot, double expected_rad) {
  standing_.clear();
  const Pose2 frame{robot.x_m, robot.y_m, expected_rad};
  const GridCell first = grid.first();
  for (int y = first.y; y < first.y + LocalGrid::kSide; ++y) {
    for (int x = first.x; x < first.x + LocalGrid::kSide; ++x) {
      if (from == From::things ? !still_thing(grid, {x, y}) : !edge_of_floor(grid, {x, y}))
        continue;
      const Point2 place = inverse_transform(frame, LocalGrid::centre_of({x, y}));
      if (std::abs(place.x_m) > kAhead_m || standing_.size() >= kMostCells) continue;
      standing_.push_back(place);
    }
  }
}

WallFitter::Line WallFitter::strongest(double turn_rad, double side) const {
  std::array<Bin, kBins> bins;
  const double c = std::cos(turn_rad);
  const double s = std::sin(turn_rad);
  for (const Point2& place : standing_) {
    const double off_m = side * (c * place.y_m - s * place.x_m) - kNearestWall_m;
    if (off_m < 0.0 || off_m >= kBins * kBin_m) continue;
    Bin& bin = bins[static_cast<std::size_t>(off_m / kBin_m)];
    const auto along_m = static_cast<float>(c * place.x_m + s * place.y_m);
    bin.cells += 1.0F;
    bin.least_m = std::min(bin.least_m, along_m);
    bin.most_m = std::max(bin.most_m, along_m);
    const auto piece =
        static_cast<unsigned>((static_cast<double>(along_m) + kPiecesFrom_m) / kPiece_m);
    bin.pieces |= std::uint64_t{1} << std::min(63U, piece);
  }
  Line best;
  for (std::size_t i = 1; i + 1 < bins.size(); ++i) {
    const double sum = bins[i - 1].cells + bins[i].cells + bins[i + 1].cells;
    // The squared middle prefers sharp walls: a wrong heading smears one over many bins.
    const double score = bins[i].cells * sum;
    const float length_m = bins[i].most_m - bins[i].least_m;
    if (score <= best.score || sum < kLeastScore || length_m < kLeastLength_m) continue;
    if (!solid(bins[i - 1], bins[i], bins[i + 1])) continue;
    const double shift = (bins[i + 1].cells - bins[i - 1].cells) / sum;
    best = {score, kNearestWall_m + (static_cast<double>(i) + 0.5 + shift) * kBin_m, true};
  }
  return best;
}

WallFit WallFitter::fit(const LocalGrid& grid, const Pose2& robot, double expected_rad) {
  gather(From::things, grid, robot, expected_rad);
  return fit_gathered(expected_rad);
}

WallFit WallFitter::fit_edges(const LocalGrid& grid, const Pose2& robot, double expected_rad,
                              double width_m) {
  gather(From::edges, grid, robot, expected_rad);
  WallFit fit = fit_gathered(expected_rad);
  const bool plausible =
      fit.left && fit.right && std::abs(fit.left_m + fit.right_m - width_m) < kWidthTolerance_m;
  if (!plausible) fit.valid = false;
  return fit;
}

WallFit WallFitter::fit_gathered(double expected_rad) const {
  WallFit fit;
  if (static_cast<double>(standing_.size()) < kLeastScore) return fit;
  std::array<double, 2 * kTurns + 1> scores{};
  int best = 0;
  for (int k = 0; k <= 2 * kTurns; ++k) {
    const double turn_rad = (k - kTurns) * kTurn_rad;
    const auto at = static_cast<std::size_t>(k);
    scores[at] = strongest(turn_rad, 1.0).score + strongest(turn_rad, -1.0).score;
    if (scores[at] > scores[static_cast<std::size_t>(best)]) best = k;
  }
  if (best == 0 || best == 2 * kTurns || scores[static_cast<std::size_t>(best)] <= 0.0) return fit;
  const double before = scores[static_cast<std::size_t>(best - 1)];
  const double peak = scores[static_cast<std::size_t>(best)];
  const double after = scores[static_cast<std::size_t>(best + 1)];
  const double bend = before - 2.0 * peak + after;
  const double part = bend < 0.0 ? std::clamp(0.5 * (before - after) / bend, -0.5, 0.5) : 0.0;
  const double turn_rad = (best - kTurns + part) * kTurn_rad;
  const Line left = strongest(turn_rad, 1.0);
  const Line right = strongest(turn_rad, -1.0);
  fit.valid = left.found || right.found;
  fit.heading_rad = wrap_angle(expected_rad + turn_rad);
  fit.left = left.found;
  fit.right = right.found;
  fit.left_m = left.distance_m;
  fit.right_m = right.distance_m;
  return fit;
}

}  // namespace striate::memory
