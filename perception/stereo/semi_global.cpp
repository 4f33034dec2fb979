#include "striate/perception/stereo/semi_global.hpp"

#include <algorithm>
#include <cstring>

namespace striate::perception {

using stereo_kernels::kStripRows;
using stereo_kernels::SweepStep;

stereo_kernels::PathLine SemiGlobal::path_line(std::size_t side, std::size_t direction) {
  return {path_lines_[side][direction].line(0), smallest_[side][direction].row(0)};
}

stereo_kernels::PathLine SemiGlobal::strip_line(std::size_t side) {
  return {strip_paths_[side].row(0), strip_paths_[side].row(1)};
}

/// Paths start anew in the first line and beside it: zero.
void SemiGlobal::start_paths() {
  // Elements that paths beside the first and last column need
  constexpr int kMargin = Volume<std::uint8_t>::kMargin;
  const int width = costs_->width(), disparities = costs_->disparities;
  const auto bytes = static_cast<std::size_t>(width) + 2;
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t k = 0; k < 3; ++k) {
      path_lines_[side][k].resize(1, disparities, width);
      smallest_[side][k].resize(width, 1, kMargin, 0);
      const stereo_kernels::PathLine line = path_line(side, k);
      const int stride = path_lines_[side][k].stride();
      for (int d = 0; d < disparities; ++d) std::memset(line.costs + d * stride - 1, 0, bytes);
      std::memset(line.smallest - 1, 0, bytes);
    }
  }
}

void SemiGlobal::begin(const Volume<std::uint8_t>& costs, int height) {
  costs_ = &costs;
  height_ = height;
  const int width = costs.width(), disparities = costs.disparities;
  from_above_.resize(height, disparities, width);
  sums_.resize(1, disparities, width);
  level_means_.resize(std::min(height, kStripRows), disparities, width);
  strip_costs_.resize(disparities * kStripRows, width, 0, 0);
  strip_means_.resize(disparities * kStripRows, width, 0, 0);
  for (Plane<std::uint8_t>& paths : strip_paths_) paths.resize(disparities * kStripRows, 2, 0, 0);
  start_paths();
}

void SemiGlobal::sweep_steep(int y, bool downwards) {
  const SweepStep step{costs_->line(y),     costs_->stride(), costs_->width(),
                       costs_->disparities, small_penalty_,   large_penalty_};
  const auto side = static_cast<std::size_t>((downwards ? y : height_ - 1 - y) % 2);
  stereo_kernels::ThreePaths paths;
  for (std::size_t k = 0; k < 3; ++k) {
    paths.before[k] = path_line(side, k);
    paths.here[k] = path_line(1 - side, k);
  }
  paths.others = downwards ? nullptr : from_above_.line(y);
  paths.sums = downwards ? from_above_.line(y) : sums_.line(0);
  paths.sum_stride = sums_.stride();
  stereo_kernels::sweep_three(step, paths);
}

/// The horizontal paths of `rows` rows from y on, at most kStripRows.
void SemiGlobal::sweep_level(int y, int rows) {
  const int width = costs_->width(), disparities = costs_->disparities;
  stereo_kernels::turn({costs_->line(y), costs_->line_step(), costs_->stride()},
                       {rows, width, disparities},
                       {strip_costs_.row(0), strip_costs_.stride(), kStripRows});
  start_strip_paths();
  for (int x = 0; x < width; ++x) sweep_rightwards(x);
  start_strip_paths();
  for (int x = width - 1; x >= 0; --x) sweep_leftwards(x);
  stereo_kernels::turn({strip_means_.row(0), strip_means_.stride(), kStripRows},
                       {width, rows, disparities},
                       {level_means_.line(0), level_means_.line_step(), level_means_.stride()});
}

void SemiGlobal::start_strip_paths() {
  const int count = costs_->disparities * kStripRows;
  for (Plane<std::uint8_t>& paths : strip_paths_) {
    std::fill_n(paths.row(0), count, std::uint8_t{0});
    std::fill_n(paths.row(1), kStripRows, std::uint8_t{0});
  }
}

/// The path costs are written where the means will be.
void SemiGlobal::sweep_rightwards(int x) {
  const auto side = static_cast<std::size_t>(x % 2);
  stereo_kernels::PathLine before = strip_line(side), here = strip_line(1 - side);
  if (x > 0) before.costs = strip_means_.row(x - 1);
  here.costs = strip_means_.row(x);
  stereo_kernels::sweep_straight(strip_step(x), {before, here, nullptr});
}

void SemiGlobal::sweep_leftwards(int x) {
  const auto side = static_cast<std::size_t>(x % 2);
  stereo_kernels::sweep_straight(strip_step(x),
                                 {strip_line(side), strip_line(1 - side), strip_means_.row(x)});
}

SweepStep SemiGlobal::strip_step(int x) const {
  return {strip_costs_.row(x), kStripRows,     kStripRows,
          costs_->disparities, small_penalty_, large_penalty_};
}

void SemiGlobal::take_row(int y) {
  sweep_steep(y, true);
  if (y + 1 == height_) start_paths();
}

SmoothedCosts SemiGlobal::finish_row(int y) {
  const int in_strip = y % kStripRows;
  if (in_strip + 1 == kStripRows || y + 1 == height_) sweep_level(y - in_strip, in_strip + 1);
  sweep_steep(y, false);
  return {sums_.line(0), sums_.stride(), level_means_.line(in_strip), level_means_.stride()};
}

}  // namespace striate::perception
