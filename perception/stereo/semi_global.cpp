#include "perception/stereo/semi_global.hpp"

#include <cstring>

namespace striate {

using stereo_kernels::SweepStep;

stereo_kernels::PathLine SemiGlobal::path_line(std::size_t side, std::size_t direction) {
  return {path_lines_[side][direction].line(0), smallest_[side][direction].row(0)};
}

/// Paths start anew in the first line and beside it: zero.
void SemiGlobal::start_paths(int width, int disparities) {
  constexpr int kMargin = Volume<std::uint8_t>::kMargin;
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

void SemiGlobal::sweep_steep(const Volume<std::uint8_t>& costs, int height) {
  SweepStep step{nullptr,           costs.stride(), costs.width(),
                 costs.disparities, small_penalty_, large_penalty_};
  for (const bool downwards : {true, false}) {
    start_paths(costs.width(), costs.disparities);
    for (int n = 0; n < height; ++n) {
      const int y = downwards ? n : height - 1 - n;
      const auto side = static_cast<std::size_t>(n % 2);
      stereo_kernels::ThreePaths paths;
      for (std::size_t k = 0; k < 3; ++k) {
        paths.before[k] = path_line(side, k);
        paths.here[k] = path_line(1 - side, k);
      }
      paths.sums = steep_sums_.line(y);
      paths.sum_stride = steep_sums_.stride();
      paths.first = downwards;
      step.costs = costs.line(y);
      stereo_kernels::sweep_three(step, paths);
    }
  }
}

void SemiGlobal::sweep_level(int width) {
  const Volume<std::uint8_t>& costs = turned_costs_;
  SweepStep step{nullptr,           costs.stride(), costs.width(),
                 costs.disparities, small_penalty_, large_penalty_};
  // Rightwards the path costs are written where the means will be.
  start_paths(costs.width(), costs.disparities);
  for (int x = 0; x < width; ++x) {
    step.costs = costs.line(x);
    stereo_kernels::PathLine before = path_line(x % 2 == 0 ? 0 : 1, 0);
    stereo_kernels::PathLine here = path_line(x % 2 == 0 ? 1 : 0, 0);
    if (x > 0) before.costs = turned_means_.line(x - 1);
    here.costs = turned_means_.line(x);
    stereo_kernels::sweep_straight(step, {before, here, nullptr});
  }
  start_paths(costs.width(), costs.disparities);
  for (int n = 0; n < width; ++n) {
    const int x = width - 1 - n;
    const auto side = static_cast<std::size_t>(n % 2);
    step.costs = costs.line(x);
    stereo_kernels::sweep_straight(
        step, {path_line(side, 0), path_line(1 - side, 0), turned_means_.line(x)});
  }
}

void SemiGlobal::smooth(const Volume<std::uint8_t>& costs, int height) {
  const int width = costs.width();
  turned_costs_.resize(width, costs.disparities, height);
  turned_means_.resize(width, costs.disparities, height);
  level_means_.resize(height, costs.disparities, width);
  steep_sums_.resize(height, costs.disparities, width);
  stereo_kernels::turn(costs, {height, width, costs.disparities}, turned_costs_);
  sweep_level(width);
  stereo_kernels::turn(turned_means_, {width, height, costs.disparities}, level_means_);
  sweep_steep(costs, height);
}

}  // namespace striate
