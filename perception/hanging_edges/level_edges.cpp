#include "striate/perception/hanging_edges/level_edges.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace striate::perception {
namespace {

/// Grey levels a row, after smoothing: three times what noise of 2 levels leaves (by hand)
constexpr float kLeastChange = 2.0F;
/// Of the change across: a level edge rises or falls by less than one row in two columns
constexpr float kLevelShare = 0.5F;
constexpr int kHole_px = 4;  // columns without the edge that a chain bridges (by hand)
/// Of the edge's own mean change: where it has become weaker it has ended (by hand)
constexpr float kEnded = 0.45F;
/// Columns to the border: the smoothing reaches as far, so an end there is the border's
constexpr int kBorder_px = 4;

struct Changes {
  cv::Mat1f down, along;
};

/// Smoothed five columns along, and but one row to either side across: it is level edges that
/// count.
Changes differentiate_level(const cv::Mat1b& grey) {
  cv::Mat1f smooth;
  cv::GaussianBlur(cv::Mat1f(grey), smooth, {5, 3}, 1.2, 0.8, cv::BORDER_REPLICATE);
  Changes changes;
  cv::Sobel(smooth, changes.down, CV_32F, 0, 1, 1, 0.5, 0.0, cv::BORDER_REPLICATE);
  cv::Sobel(smooth, changes.along, CV_32F, 1, 0, 1, 0.5, 0.0, cv::BORDER_REPLICATE);
  return changes;
}

struct EdgeInColumn {
  float row_px;
  float change;
};

/// The level edges that column u crosses, from above.
void edges_in_column(const Changes& changes, cv::Range rows, int u,
                     std::vector<EdgeInColumn>& found) {
  found.clear();
  for (int v = std::max(1, rows.start); v < std::min(rows.end, changes.down.rows - 1); ++v) {
    const float here = changes.down(v, u);
    const float strength = std::abs(here);
    if (strength < kLeastChange || std::abs(changes.along(v, u)) > kLevelShare * strength) continue;
    const float sign = here < 0.0F ? -1.0F : 1.0F;
    const float above = sign * changes.down(v - 1, u);
    const float below = sign * changes.down(v + 1, u);
    if (strength < above || strength <= below) continue;
    const float bend = above - 2.0F * strength + below;
    const float shift = bend < 0.0F ? 0.5F * (above - below) / bend : 0.0F;
    found.push_back({static_cast<float>(v) + std::clamp(shift, -0.5F, 0.5F), here});
  }
}

struct Chain {
  int from_u = 0;
  int last_u = 0;
  std::vector<float> rows, changes;  ///< of each column; holes repeat the last
  bool taken = false;                ///< goes on in the newest column
};

void extend(Chain& chain, int u, const EdgeInColumn& edge) {
  const float from = chain.rows.back();
  for (int hole = chain.last_u + 1; hole < u; ++hole) {
    const auto share =
        static_cast<float>(hole - chain.last_u) / static_cast<float>(u - chain.last_u);
    chain.rows.push_back(from + share * (edge.row_px - from));
    chain.changes.push_back(edge.change);
  }
  chain.rows.push_back(edge.row_px);
  chain.changes.push_back(edge.change);
  chain.last_u = u;
  chain.taken = true;
}

/// Its two ends, without the columns in which it fades out.
LevelEdge without_faded_ends(const Chain& chain, int width) {
  float mean = 0.0F;
  for (const float change : chain.changes) mean += change;
  mean /= static_cast<float>(chain.changes.size());
  const auto ended = [&](std::size_t k) {
    return std::abs(chain.changes[k]) < kEnded * std::abs(mean);
  };
  std::size_t first = 0;
  std::size_t last = chain.rows.size() - 1;
  while (first < last && ended(first)) ++first;
  while (last > first && ended(last)) --last;
  LevelEdge edge;
  edge.from_u_px = chain.from_u + static_cast<int>(first);
  edge.to_u_px = chain.from_u + static_cast<int>(last);
  edge.row_px.assign(chain.rows.begin() + static_cast<std::ptrdiff_t>(first),
                     chain.rows.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  edge.brightens = mean > 0.0F;
  edge.cut_left = edge.from_u_px < kBorder_px;
  edge.cut_right = edge.to_u_px >= width - kBorder_px;
  return edge;
}

}  // namespace

std::vector<LevelEdge> find_level_edges(const cv::Mat1b& grey, cv::Range rows, int shortest_px) {
  std::vector<LevelEdge> edges;
  if (grey.rows < 8 || grey.cols < 8) return edges;
  const Changes changes = differentiate_level(grey);
  std::vector<Chain> open;
  std::vector<EdgeInColumn> found;
  const auto close = [&](const Chain& chain) {
    if (static_cast<int>(chain.rows.size()) < shortest_px) return;
    LevelEdge edge = without_faded_ends(chain, grey.cols);
    if (edge.length_px() >= shortest_px) edges.push_back(std::move(edge));
  };
  for (int u = 0; u < grey.cols; ++u) {
    edges_in_column(changes, rows, u, found);
    for (Chain& chain : open) chain.taken = false;
    for (const EdgeInColumn& edge : found) {
      Chain* best = nullptr;
      float nearest_px = 1.0F;
      for (Chain& chain : open) {
        const float apart_px = std::abs(chain.rows.back() - edge.row_px);
        const bool same = chain.changes.back() * edge.change > 0.0F;
        if (chain.taken || !same || apart_px >= nearest_px) continue;
        nearest_px = apart_px;
        best = &chain;
      }
      if (best != nullptr) {
        extend(*best, u, edge);
      } else {
        open.push_back({u, u, {edge.row_px}, {edge.change}, true});
      }
    }
    for (const Chain& chain : open) {
      if (u - chain.last_u > kHole_px) close(chain);
    }
    std::erase_if(open, [&](const Chain& chain) { return u - chain.last_u > kHole_px; });
  }
  for (const Chain& chain : open) close(chain);
  return edges;
}

}  // namespace striate::perception
