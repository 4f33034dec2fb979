#include "striate/perception/keypoints/keep_apart.hpp"

#include <algorithm>
#include <cmath>

namespace striate::perception {
namespace {

constexpr int kNeighbours = 2;  ///< scales: an octave

int cell_of(double at_px, double cell_px, int count) {
  return std::clamp(static_cast<int>(std::floor(at_px / cell_px)), 0, count - 1);
}

}  // namespace

void KeepApart::begin(int width, int height, double finest_radius_px, int scales) {
  noted_.clear();
  grids_.resize(static_cast<std::size_t>(scales));
  double radius_px = finest_radius_px;
  for (Grid& grid : grids_) {
    grid.cell_px = std::max(2.0, 2.0 * radius_px);
    grid.columns = static_cast<int>(width / grid.cell_px) + 1;
    grid.rows = static_cast<int>(height / grid.cell_px) + 1;
    grid.first.assign(static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows),
                      -1);
    radius_px *= std::sqrt(2.0);
  }
}

bool KeepApart::is_near(const FoundPlace& place, const Grid& grid) const {
  // Radii differ by at most an octave, so that none reaches further than a cell of the other.
  const double reach_px = std::max(place.radius_px, grid.cell_px);
  const int left = cell_of(place.u_px - reach_px, grid.cell_px, grid.columns);
  const int right = cell_of(place.u_px + reach_px, grid.cell_px, grid.columns);
  const int top = cell_of(place.v_px - reach_px, grid.cell_px, grid.rows);
  const int bottom = cell_of(place.v_px + reach_px, grid.cell_px, grid.rows);
  for (int row = top; row <= bottom; ++row) {
    for (int column = left; column <= right; ++column) {
      int at = grid.first[static_cast<std::size_t>(row * grid.columns + column)];
      for (; at >= 0; at = noted_[static_cast<std::size_t>(at)].next) {
        const FoundPlace& other = noted_[static_cast<std::size_t>(at)].place;
        const double radius_px = std::max(place.radius_px, other.radius_px);
        const double du = place.u_px - other.u_px, dv = place.v_px - other.v_px;
        if (du * du + dv * dv < radius_px * radius_px) return true;
      }
    }
  }
  return false;
}

bool KeepApart::keep(const FoundPlace& place, int scale) {
  const int last = static_cast<int>(grids_.size()) - 1;
  for (int s = std::max(0, scale - kNeighbours); s <= std::min(last, scale + kNeighbours); ++s) {
    if (is_near(place, grids_[static_cast<std::size_t>(s)])) return false;
  }
  Grid& grid = grids_[static_cast<std::size_t>(scale)];
  const int column = cell_of(place.u_px, grid.cell_px, grid.columns);
  const int row = cell_of(place.v_px, grid.cell_px, grid.rows);
  int& first = grid.first[static_cast<std::size_t>(row * grid.columns + column)];
  noted_.push_back({place, first});
  first = static_cast<int>(noted_.size()) - 1;
  return true;
}

}  // namespace striate::perception
