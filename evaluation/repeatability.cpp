#include "striate/evaluation/repeatability.hpp"

#include <algorithm>

#include "striate/evaluation/homography_sequence.hpp"

namespace striate::evaluation {
namespace {

bool inside(cv::Point2d at, cv::Size size) {
  return at.x >= 0.0 && at.y >= 0.0 && at.x <= size.width - 1 && at.y <= size.height - 1;
}

struct Pairing {
  double distance2_px = 0.0;
  std::size_t first = 0, second = 0;
};

}  // namespace

Repeatability repeatability(const std::vector<cv::Point2d>& first,
                            const std::vector<cv::Point2d>& second, const ImagePair& pair,
                            double tolerance_px) {
  std::vector<cv::Point2d> there, here;
  for (const cv::Point2d& at : first) {
    const cv::Point2d to = projected(pair.to_second, at);
    if (inside(to, pair.second)) there.push_back(to);
  }
  const cv::Matx33d back = pair.to_second.inv();
  for (const cv::Point2d& at : second) {
    if (inside(projected(back, at), pair.first)) here.push_back(at);
  }
  std::vector<Pairing> pairings;
  for (std::size_t a = 0; a < there.size(); ++a) {
    for (std::size_t b = 0; b < here.size(); ++b) {
      const cv::Point2d apart = there[a] - here[b];
      const double distance2_px = apart.ddot(apart);
      if (distance2_px <= tolerance_px * tolerance_px) pairings.push_back({distance2_px, a, b});
    }
  }
  std::ranges::stable_sort(pairings, {}, &Pairing::distance2_px);
  std::vector<bool> first_used(there.size(), false), second_used(here.size(), false);
  Repeatability result;
  result.common = static_cast<int>(std::min(there.size(), here.size()));
  for (const Pairing& p : pairings) {
    if (first_used[p.first] || second_used[p.second]) continue;
    first_used[p.first] = second_used[p.second] = true;
    ++result.repeated;
  }
  return result;
}

}  // namespace striate::evaluation
