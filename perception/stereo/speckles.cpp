#include "striate/perception/stereo/speckles.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace striate::perception {
namespace {

/// px of disparity between neighbours of one surface: what P1 of the smoothing pays for.
constexpr float kStep_px = 1.0F;
/// Per cent of a piece that may be repeated elsewhere. Of made chessboards, slats and dots that
/// were matched wrongly 93 to 100 are, of things in 13 public and 20 simulated pairs at most 60
constexpr int kMostRepeated_percent = 85;

bool together(float a, float b) {
  return std::abs(a - b) <= kStep_px;  // unknown and known: infinite; unknown both: not a number
}

}  // namespace

int Speckles::begin_run() {
  joined_.push_back(static_cast<int>(joined_.size()));
  pieces_.emplace_back();
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
  Piece& whole = pieces_[static_cast<std::size_t>(first)];
  whole.size_px += pieces_[static_cast<std::size_t>(other)].size_px;
  whole.repeated_px += pieces_[static_cast<std::size_t>(other)].repeated_px;
}

void Speckles::join_row(const DisparityMap& map, const cv::Mat1b& repeated, int y) {
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
    Piece& piece = pieces_[static_cast<std::size_t>(piece_of(runs[x]))];
    ++piece.size_px;
    piece.repeated_px += repeated(y, x) != 0;
    if (above == nullptr || !together(here[x], above[x])) continue;
    if (runs[x] == joined_here && runs_above[x] == joined_above) continue;
    joined_here = runs[x];
    joined_above = runs_above[x];
    join(joined_here, joined_above);
  }
}

void Speckles::drop(int least_px, const cv::Mat1b& repeated, DisparityMap& map) {
  const int width = map.disparity_px.cols, height = map.disparity_px.rows;
  run_of_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  joined_.reserve(run_of_.size());  // the worst image has a run for every pixel
  pieces_.reserve(run_of_.size());
  joined_.clear();
  pieces_.clear();
  for (int y = 0; y < height; ++y) join_row(map, repeated, y);
  for (int y = 0; y < height; ++y) {
    const int* runs = run_of_.data() + static_cast<std::ptrdiff_t>(y) * width;
    float* disparities = map.disparity_px.ptr<float>(y);
    float* confidences = map.confidence.ptr<float>(y);
    int last_run = -1;
    bool dropped = false;
    for (int x = 0; x < width; ++x) {
      if (runs[x] < 0) continue;
      if (runs[x] != last_run) {
        last_run = runs[x];
        const Piece& piece = pieces_[static_cast<std::size_t>(piece_of(last_run))];
        dropped = piece.size_px < least_px ||
                  100 * piece.repeated_px > kMostRepeated_percent * piece.size_px;
      }
      if (!dropped) continue;
      disparities[x] = kNoMatch;
      confidences[x] = 0.0F;
    }
  }
}

}  // namespace striate::perception
