#include "perception/stereo/semi_global.hpp"

#include <cstring>

namespace striate {

void SemiGlobal::sweep(const Volume<std::uint8_t>& costs, int lines, bool three,
                       Volume<std::uint16_t>& sums) {
  const int width = costs.plane.width();
  for (auto& side : path_lines_) {
    for (auto& volume : side) volume.resize(1, costs.disparities, width);
  }
  for (auto& side : smallest_) {
    for (auto& plane : side) plane.resize(width, 1, 1, 0);
  }
  auto lines_of = [&](std::size_t side) {
    std::array<stereo_kernels::PathLine, 3> result;
    for (std::size_t k = 0; k < 3; ++k) {
      result[k] = {path_lines_[side][k].line(0), smallest_[side][k].row(0)};
    }
    return result;
  };
  for (const bool forward : {true, false}) {
    // Before the first line paths start anew: all zero.
    for (std::size_t k = 0; k < 3; ++k) {
      Plane<std::uint8_t>& plane = path_lines_[0][k].plane;
      for (int d = 0; d < costs.disparities; ++d) {
        std::memset(plane.row(d) - 1, 0, static_cast<std::size_t>(width) + 2);
        path_lines_[1][k].plane.row(d)[-1] = 0;
      }
      std::memset(smallest_[0][k].row(0) - 1, 0, static_cast<std::size_t>(width) + 2);
      smallest_[1][k].row(0)[-1] = 0;
    }
    stereo_kernels::SweepStep step;
    step.stride = costs.plane.stride();
    step.sum_stride = sums.plane.stride();
    step.width = width;
    step.disparities = costs.disparities;
    step.small_penalty = small_penalty_;
    step.large_penalty = large_penalty_;
    step.first = forward;
    for (int n = 0; n < lines; ++n) {
      const int y = forward ? n : lines - 1 - n;
      const auto side = static_cast<std::size_t>(n % 2);
      step.before = lines_of(side);
      step.here = lines_of(1 - side);
      step.costs = costs.line(y);
      step.sums = sums.line(y);
      if (three) {
        stereo_kernels::sweep_three(step);
      } else {
        stereo_kernels::sweep_straight(step);
      }
    }
  }
}

void SemiGlobal::smooth(const Volume<std::uint8_t>& costs, int height,
                        Volume<std::uint16_t>& sums) {
  const int width = costs.plane.width();
  sums.resize(height, costs.disparities, width);
  sweep(costs, height, true, sums);
  // The two horizontal paths: the same on the volume turned by swapping rows and columns.
  turned_costs_.resize(width, costs.disparities, height);
  turned_sums_.resize(width, costs.disparities, height);
  for (int y = 0; y < height; ++y) {
    for (int d = 0; d < costs.disparities; ++d) {
      const std::uint8_t* from = costs.line(y) + d * costs.plane.stride();
      for (int x = 0; x < width; ++x) {
        turned_costs_.line(x)[d * turned_costs_.plane.stride() + y] = from[x];
      }
    }
  }
  sweep(turned_costs_, width, false, turned_sums_);
  for (int y = 0; y < height; ++y) {
    for (int d = 0; d < costs.disparities; ++d) {
      std::uint16_t* to = sums.line(y) + d * sums.plane.stride();
      for (int x = 0; x < width; ++x) {
        to[x] = static_cast<std::uint16_t>(
            to[x] + turned_sums_.line(x)[d * turned_sums_.plane.stride() + y]);
      }
    }
  }
}

}  // namespace striate
