#include "striate/perception/recognition/consensus.hpp"

#include <algorithm>
#include <cmath>

#include "striate/base/index_within.hpp"

namespace striate::perception {
namespace {

double squared(double value) {
  return value * value;
}

double distance_sq_px(const Pose& pose, const PlacePair& pair) {
  return squared(pose.u_of(pair.view.u_px, pair.view.v_px) - pair.image.u_px) +
         squared(pose.v_of(pair.view.u_px, pair.view.v_px) - pair.image.v_px);
}

/// What a pair's own pose does to a vector along u: (cos, sin) of its turn, times its scale.
struct Turn {
  double u, v;
};

/// Whether two turns differ by less than a factor of two and less than 36 degrees.
bool alike(const Turn& a, const Turn& b) {
  const double dot = a.u * b.u + a.v * b.v;
  const double aa = a.u * a.u + a.v * a.v, bb = b.u * b.u + b.v * b.v;
  constexpr double kCosineSquared = 0.6545;  // cos^2 of 36 degrees
  return dot > 0.0 && dot * dot > kCosineSquared * aa * bb && aa < 4.0 * bb && bb < 4.0 * aa;
}

/// The similarity part of a pose.
Turn turn_of(const Pose& pose) {
  return {(pose.a + pose.e) / 2, (pose.d - pose.b) / 2};
}

}  // namespace

int image_place(const PlacePair& pair) {
  return round_within(pair.image.v_px, 0, 32767) * 65536 + round_within(pair.image.u_px, 0, 65535);
}

int different_keypoints(std::span<const PlacePair> pairs, std::vector<int>& points) {
  int count = 0;
  for (const bool of_view : {true, false}) {
    points.clear();
    for (const PlacePair& pair : pairs) {
      points.push_back(of_view ? pair.view_point : image_place(pair));
    }
    std::ranges::sort(points);
    const auto repeated = std::ranges::unique(points);
    const int different = static_cast<int>(repeated.begin() - points.begin());
    count = of_view ? different : std::min(count, different);
  }
  return count;
}

bool turned_alike(const Pose& a, const Pose& b) {
  return alike(turn_of(a), turn_of(b));
}

/// The pair whose proposal most pairs support; of equals the first.
std::size_t ConsensusFinder::propose(std::span<const PlacePair> pairs, double tolerance_px) {
  std::size_t best = 0;
  int most = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Pose& pose = poses_[i];
    const Turn turn = turn_of(pose);
    const double limit = squared(tolerance_px) * pose.determinant();
    int support = 0;
    for (std::size_t j = 0; j < pairs.size(); ++j) {
      if (distance_sq_px(pose, pairs[j]) >= limit) continue;
      support += alike(turn, turn_of(poses_[j])) ? 1 : 0;
    }
    if (support > most) {
      most = support;
      best = i;
    }
  }
  return best;
}

void ConsensusFinder::gather(std::span<const PlacePair> pairs, const Pose& pose,
                             double tolerance_px) {
  agreeing_.clear();
  const Turn turn = turn_of(pose);
  const double limit = squared(tolerance_px * pose.scale());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (distance_sq_px(pose, pairs[k]) >= limit) continue;
    if (alike(turn, turn_of(poses_[k]))) agreeing_.push_back(pairs[k]);
  }
}

bool ConsensusFinder::plausible(const Pose& pose) const {
  return pose.stretch() < settings_.most_stretch && pose.scale() > settings_.least_scale &&
         pose.scale() < 1.0 / settings_.least_scale;
}

Consensus ConsensusFinder::find(std::span<const PlacePair> pairs, double width_px,
                                double height_px) {
  if (pairs.size() < 3) return {};
  const double side_px = std::sqrt(width_px * height_px);
  poses_.clear();
  for (const PlacePair& pair : pairs) poses_.push_back(pose_of_pair(pair));
  Pose pose = poses_[propose(pairs, settings_.vote_tolerance * side_px)];
  gather(pairs, pose, settings_.vote_tolerance * side_px);
  // Of fit and gathering; members no longer change much after a few (ours)
  constexpr int kRounds = 5;
  for (int round = 0; round < kRounds; ++round) {
    if (agreeing_.size() < 3) return {};
    // Six parameters through few points fit anything.
    const bool few = agreeing_.size() < 6 || round == 0;
    pose = few ? fit_similarity(agreeing_) : fit_affine(agreeing_);
    if (!plausible(pose)) return {};
    gather(pairs, pose, settings_.fit_tolerance * side_px * (round == 0 ? 2.0 : 1.0));
  }
  return {different_keypoints(agreeing_, points_), pose};
}

}  // namespace striate::perception
