#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "striate/config/quantity.hpp"

namespace striate::config {
namespace {

/// Damerau-Levenshtein distance (optimal string alignment): a swap of two letters is one slip.
int edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::vector<int>> cost(a.size() + 1, std::vector<int>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) cost[i][0] = static_cast<int>(i);
  std::iota(cost[0].begin(), cost[0].end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replace = cost[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      cost[i][j] = std::min({cost[i - 1][j] + 1, cost[i][j - 1] + 1, replace});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        cost[i][j] = std::min(cost[i][j], cost[i - 2][j - 2] + 1);
      }
    }
  }
  return cost[a.size()][b.size()];
}

}  // namespace

std::string suggest(std::string_view wrong, const std::vector<std::string>& candidates) {
  const std::string* best = nullptr;
  int best_distance = std::max<int>(2, static_cast<int>(wrong.size()) / 2);
  for (const std::string& candidate : candidates) {
    const int distance = edit_distance(wrong, candidate);
    if (distance < best_distance ||
        (best == nullptr && distance == best_distance && wrong.size() > 3)) {
      best = &candidate;
      best_distance = distance;
    }
  }
  return best == nullptr ? std::string{} : fmt::format("did you mean '{}'?", *best);
}

}  // namespace striate::config
