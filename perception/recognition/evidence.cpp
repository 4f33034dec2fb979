#include "striate/perception/recognition/evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "striate/perception/recognition/view_parts.hpp"

namespace striate::perception {
namespace {

/// log10 of the number of ways to choose `k` of `n`.
double log10_choose(int n, int k) {
  return (std::lgamma(n + 1.0) - std::lgamma(k + 1.0) - std::lgamma(n - k + 1.0)) /
         std::numbers::ln10;
}

constexpr double kHalfWay = 10.0;  // powers of ten from a score of 0.5 to one of 0.75 (ours)

constexpr int kPartsAcross = 4;  // of a view: a label on a box covers one or two (ours)
using Parts = std::array<int, std::size_t{kPartsAcross} * kPartsAcross>;

}  // namespace

PairsUnderPose pairs_under(std::span<const PlacePair> pairs, const Pose& pose, double width_px,
                           double height_px) {
  PairsUnderPose all;
  all.pairs = static_cast<int>(pairs.size());
  const double determinant = pose.determinant();
  if (pairs.empty() || !(determinant > 0.0)) return all;
  int within = 0, as_turned = 0;
  for (const PlacePair& pair : pairs) {
    const double du = pair.image.u_px - pose.c, dv = pair.image.v_px - pose.f;
    const double u = (pose.e * du - pose.b * dv) / determinant;
    const double v = (pose.a * dv - pose.d * du) / determinant;
    within += u > 0.0 && v > 0.0 && u < width_px && v < height_px ? 1 : 0;
    as_turned += turned_alike(pose, pose_of_pair(pair)) ? 1 : 0;
  }
  all.within = within / static_cast<double>(all.pairs);
  all.as_turned = as_turned / static_cast<double>(all.pairs);
  return all;
}

void residuals_of(std::span<const PlacePair> agreeing, const Pose& pose, double side_px,
                  std::vector<double>& residuals) {
  residuals.clear();
  for (std::size_t i = 0; i < agreeing.size(); ++i) {
    const PlacePair& pair = agreeing[i];
    const auto same = [&](const PlacePair& other) {
      return other.view_point == pair.view_point || image_place(other) == image_place(pair);
    };
    // What is listed twice, with two angles or at two sizes, is one keypoint: its first stands.
    if (std::ranges::any_of(agreeing.first(i), same)) continue;
    const double away_px = std::hypot(pose.u_of(pair.view.u_px, pair.view.v_px) - pair.image.u_px,
                                      pose.v_of(pair.view.u_px, pair.view.v_px) - pair.image.v_px);
    residuals.push_back(away_px / (pose.scale() * side_px));
  }
  std::ranges::sort(residuals);
}

double log10_chance(const PairsUnderPose& all, std::span<const double> residuals, int carried) {
  constexpr int kCarry = 3;  // pairs: an affine map has six parameters
  // Of a view's side: what true keypoints err by; 0.008 told true from wrong no better
  constexpr double kLeastResidual = 0.012;
  constexpr double kLeast = 1e-6;  // below it the count of pairs says nothing about a chance (ours)
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    const int agree = static_cast<int>(i) + 1 + carried;
    if (agree <= kCarry) continue;
    if (agree > all.pairs) break;
    const double near = std::max(kLeastResidual, residuals[i]);
    const double one =
        std::max(kLeast, std::numbers::pi * near * near * all.within * all.as_turned);
    least = std::min(least, std::log10(all.pairs) + log10_choose(all.pairs, agree) +
                                log10_choose(agree, kCarry) + (agree - kCarry) * std::log10(one));
  }
  return least;
}

double score_of_chance(double log10_expected, double most_chance) {
  const double rarer = std::log10(most_chance) - log10_expected;
  if (std::isinf(rarer)) return 0.0;
  return 0.5 + 0.5 * rarer / (kHalfWay + std::abs(rarer));
}

double log10_expected_of(double score, double most_chance) {
  const double part = 2.0 * score - 1.0;
  return std::log10(most_chance) - kHalfWay * part / (1.0 - std::abs(part));
}

double spread(std::span<const KeypointFrame> visible, std::span<const PlacePair> agreeing,
              double width_px, double height_px) {
  Parts there{}, held{};
  for (const KeypointFrame& place : visible)
    ++there[part_of_view(place, width_px, height_px, kPartsAcross)];
  for (const PlacePair& pair : agreeing)
    ++held[part_of_view(pair.view, width_px, height_px, kPartsAcross)];
  const double agrees = std::min(
      1.0, static_cast<double>(agreeing.size()) / std::max<std::size_t>(1, visible.size()));
  double expected = 0.0;
  for (const int count : there) expected += 1.0 - std::pow(1.0 - agrees, count);
  const auto parts = std::ranges::count_if(held, [](int count) { return count > 0; });
  return expected > 0.0 ? static_cast<double>(parts) / expected : 0.0;
}

}  // namespace striate::perception
