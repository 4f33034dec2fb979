#include "perception/stereo/decision.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace striate {
namespace {

constexpr int kPaths = 8;

}  // namespace

void Decision::decide_row(const Evidence& e, int y, DisparityMap& out) {
  const int width = out.disparity_px.cols;
  const int stride = e.sums.plane.stride();
  const std::uint16_t* sums = e.sums.line(y);
  const std::uint8_t* costs = e.costs.line(y);
  auto sum = [&](int x, int d) { return static_cast<int>(sums[d * stride + x]); };
  left_best_.assign(static_cast<std::size_t>(width), 0);
  right_best_.assign(static_cast<std::size_t>(width), 0);
  for (int x = 0; x < width; ++x) {
    int best = 0;
    for (int d = 1; d < std::min(e.candidates, x + 1); ++d) {
      if (sum(x, d) < sum(x, best)) best = d;
    }
    left_best_[static_cast<std::size_t>(x)] = best;
    best = 0;
    for (int d = 1; d < std::min(e.candidates, width - x); ++d) {
      if (sum(x + d, d) < sum(x + best, best)) best = d;
    }
    right_best_[static_cast<std::size_t>(x)] = best;
  }
  for (int x = 0; x < width; ++x) {
    const int best = left_best_[static_cast<std::size_t>(x)];
    const int limit = std::min(e.candidates, x + 1);
    const int smallest = sum(x, best);
    int second = 65535;
    for (int d = 0; d < limit; ++d) {
      if (std::abs(d - best) > 1) second = std::min(second, sum(x, d));
    }
    const int disagreement = std::abs(right_best_[static_cast<std::size_t>(x - best)] - best);
    float& disparity = out.disparity_px(y, x);
    float& confidence = out.confidence(y, x);
    disparity = kNoMatch;
    confidence = 0.0F;
    if (disagreement > settings_.left_right_px) continue;
    if (second < smallest * (1.0 + settings_.uniqueness)) continue;
    float texture = 0.0F;
    for (const Plane<std::int16_t>& plane : e.left.code) {
      texture += complex_response(plane.row(y)[x]);
    }
    texture /= static_cast<float>(e.left.gain);
    disparity = static_cast<float>(best);
    if (best > 0 && best + 1 < limit) {
      const int below = sum(x, best - 1), above = sum(x, best + 1);
      const int curvature = std::max(below, above) - smallest;
      if (curvature > 0) {
        disparity += 0.5F * static_cast<float>(below - above) / static_cast<float>(curvature);
      }
    }
    const float margin = static_cast<float>(second - smallest) / kPaths;
    const float raw = costs[best * e.costs.plane.stride() + x];
    const float score = 0.08F * margin - 0.02F * raw + 0.4F * std::log2(texture + 1.0F) - 0.5F;
    confidence = 1.0F / (1.0F + std::exp(-score));
  }
}

void Decision::drop_speckles(DisparityMap& out) {
  const int width = out.disparity_px.cols, height = out.disparity_px.rows;
  constexpr float kStep = 1.0F;
  stack_.clear();
  piece_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
  std::vector<int>& seen = piece_;
  for (int start = 0; start < width * height; ++start) {
    if (seen[static_cast<std::size_t>(start)] != 0) continue;
    if (out.disparity_px(start / width, start % width) == kNoMatch) continue;
    stack_.assign(1, start);
    seen[static_cast<std::size_t>(start)] = 1;
    for (std::size_t at = 0; at < stack_.size(); ++at) {
      const int y = stack_[at] / width, x = stack_[at] % width;
      const float here = out.disparity_px(y, x);
      auto visit_neighbour = [&](int v, int u) {
        if (u < 0 || v < 0 || u >= width || v >= height) return;
        const auto index = static_cast<std::size_t>(v * width + u);
        if (seen[index] != 0 || !(std::abs(out.disparity_px(v, u) - here) <= kStep)) return;
        seen[index] = 1;
        stack_.push_back(v * width + u);
      };
      visit_neighbour(y, x - 1);
      visit_neighbour(y, x + 1);
      visit_neighbour(y - 1, x);
      visit_neighbour(y + 1, x);
    }
    if (static_cast<int>(stack_.size()) >= settings_.speckle_px) continue;
    for (const int index : stack_) {
      out.disparity_px(index / width, index % width) = kNoMatch;
      out.confidence(index / width, index % width) = 0.0F;
    }
  }
}

void Decision::decide(const Evidence& evidence, DisparityMap& out) {
  for (int y = 0; y < out.disparity_px.rows; ++y) decide_row(evidence, y, out);
  drop_speckles(out);
}

}  // namespace striate
