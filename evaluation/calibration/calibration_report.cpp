#include "striate/evaluation/calibration/calibration_report.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace striate::evaluation {

std::string worst_of(std::vector<PairError> pairs) {
  constexpr std::size_t kNamed = 5;  // of a list that a person reads (by hand)
  std::ranges::sort(pairs, std::greater<>(), &PairError::reprojection_px);
  std::string text;
  for (std::size_t i = 0; i < std::min(kNamed, pairs.size()); ++i) {
    text += fmt::format("{}{} ({:.1f} px)", i == 0 ? "" : ", ", pairs[i].name,
                        pairs[i].reprojection_px);
  }
  if (pairs.size() > kNamed) text += fmt::format(" and {} more", pairs.size() - kNamed);
  return text;
}

}  // namespace striate::evaluation
