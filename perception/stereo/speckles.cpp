#include "striate/perception/stereo/speckles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace striate::perception {
namespace {

/// px of disparity between neighbours of one surface: what P1 of the smoothing pays for.
constexpr float kStep_px = 1.0F;

bool together(float a, float b) {
  return std::abs(a - b) <= kStep_px;  // unknown and known: infinite; unknown both: not a number
}

}  // namespace

int Speckles::begin_run() {
  joined_.push_back(static_cast<int>(joined_.size()));
  size_px_.push_back(0);
  return joined_.back();
}

int Speckles::piece_of(int run) {
  auto next = [this](int r) -> int& { return joined_[static_cast<std::size_t>(r)]; };
  while (next(run) != run) {
    next(run) = next(next(run));  // halves the way for the next time
    run = next(run);
  }
  return run;
}

void Speckles::join(int a, int b) {
  a = piece_of(a);
  b = piece_of(b);
  if (a == b) return;
  const int first = std::min(a, b), other = std::max(a, b);
  joined_[static_cast<std::size_t>(other)] = first;
  size_px_[static_cast<std::size_t>(first)] += size_px_[static_cast<std::size_t>(other)];
}

void Speckles::join_row(const DisparityMap& map, int y) {
  const int width = map.disparity_px.cols;
  const float* here = map.disparity_px.ptr<float>(y);
  const float* above = y > 0 ? map.disparity_px.ptr<float>(y - 1) : nullptr;
  int* runs = run_of_.data() + static_cast<std::ptrdiff_t>(y) * width;
  const int* runs_above = runs - (y > 0 ? width : 0);
  int joined_here = -1, joined_above = -1;  // the last two runs that were joined
  for (int x = 0; x < width; ++x) {
    if (here[x] == kNoMatch) {
      runs[x] = -1;
      continue;
    }
    runs[x] = x > 0 && together(here[x], here[x - 1]) ? runs[x - 1] : begin_run();
    ++size_px_[static_cast<std::size_t>(piece_of(runs[x]))];
    if (above == nullptr || !together(here[x], above[x])) continue;
    if (runs[x] == joined_here && runs_above[x] == joined_above) continue;
    joined_here = runs[x];
    joined_above = runs_above[x];
    join(joined_here, joined_above);
  }
}

void Speckles::drop(int least_px, DisparityMap& map) {
  const int width = map.disparity_px.cols, height = map.disparity_px.rows;
  run_of_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  joined_.reserve(run_of_.size());  // the worst image has a run for every pixel
  size_px_.reserve(run_of_.size());
  joined_.clear();
  size_px_.clear();
  for (int y = 0; y < height; ++y) join_row(map, y);
  for (int y = 0; y < height; ++y) {
    const int* runs = run_of_.data() + static_cast<std::ptrdiff_t>(y) * width;
    float* disparities = map.disparity_px.ptr<float>(y);
    float* confidences = map.confidence.ptr<float>(y);
    int last_run = -1;
    bool small = false;
    for (int x = 0; x < width; ++x) {
      if (runs[x] < 0) continue;
      if (runs[x] != last_run) {
        last_run = runs[x];
        small = size_px_[static_cast<std::size_t>(piece_of(last_run))] < least_px;
      }
      if (!small) continue;
      disparities[x] = kNoMatch;
      confidences[x] = 0.0F;
    }
  }
}

}  // namespace striate::perception
