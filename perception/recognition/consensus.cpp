#include "perception/recognition/consensus.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace striate {
namespace {

double squared(double value) {
  return value * value;
}

double distance_sq_px(const Pose& pose, const PlacePair& pair) {
  return squared(pose.u_of(pair.view.u_px, pair.view.v_px) - pair.picture.u_px) +
         squared(pose.v_of(pair.view.u_px, pair.view.v_px) - pair.picture.v_px);
}

/// Whether the sizes and orientations of the keypoints go with the pose.
bool alike(const Pose& pose, const PlacePair& pair) {
  const double scale = pose.scale() * pair.view.size_px / pair.picture.size_px;
  if (!(scale > 0.5 && scale < 2.0)) return false;
  const double turn = std::atan2(pose.d - pose.b, pose.a + pose.e);
  const double difference = pair.picture.angle_rad - pair.view.angle_rad - turn;
  return std::cos(difference) > std::cos(std::numbers::pi / 5);
}

}  // namespace

/// The pair whose proposal most pairs support; of equals the first.
int ConsensusFinder::propose(std::span<const PlacePair> pairs, double tolerance_px) {
  int best = 0, most = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Pose pose = pose_of_pair(pairs[i]);
    const double limit = squared(tolerance_px * pose.scale());
    int support = 0;
    for (const PlacePair& pair : pairs) {
      support += distance_sq_px(pose, pair) < limit && alike(pose, pair) ? 1 : 0;
    }
    if (support > most) {
      most = support;
      best = static_cast<int>(i);
    }
  }
  return best;
}

void ConsensusFinder::gather(std::span<const PlacePair> pairs, const Pose& pose,
                             double tolerance_px) {
  agreeing_.clear();
  const double limit = squared(tolerance_px * pose.scale());
  for (const PlacePair& pair : pairs) {
    if (distance_sq_px(pose, pair) < limit && alike(pose, pair)) agreeing_.push_back(pair);
  }
}

bool ConsensusFinder::plausible(const Pose& pose) const {
  return pose.stretch() < settings_.most_stretch && pose.scale() > settings_.least_scale &&
         pose.scale() < 1.0 / settings_.least_scale;
}

/// Several keypoints of the picture may agree with one of the view: it counts once. So does a place
/// of the picture that several keypoints of the view claim.
int ConsensusFinder::distinct() {
  int count = 0;
  for (const bool of_view : {true, false}) {
    points_.clear();
    for (const PlacePair& pair : agreeing_) {
      const int place = static_cast<int>(std::lround(pair.picture.v_px)) * 65536 +
                        static_cast<int>(std::lround(pair.picture.u_px));
      points_.push_back(of_view ? pair.view_point : place);
    }
    std::ranges::sort(points_);
    const auto repeated = std::ranges::unique(points_);
    const int different = static_cast<int>(repeated.begin() - points_.begin());
    count = of_view ? different : std::min(count, different);
  }
  return count;
}

Consensus ConsensusFinder::find(std::span<const PlacePair> pairs, double width_px,
                                double height_px) {
  if (pairs.size() < 3) return {};
  const double side_px = std::sqrt(width_px * height_px);
  const auto best = static_cast<std::size_t>(propose(pairs, settings_.vote_tolerance * side_px));
  Pose pose = pose_of_pair(pairs[best]);
  gather(pairs, pose, settings_.vote_tolerance * side_px);
  constexpr int kRounds = 5;
  for (int round = 0; round < kRounds; ++round) {
    if (agreeing_.size() < 3) return {};
    // Six parameters through few points fit anything.
    const bool few = agreeing_.size() < 6 || round == 0;
    pose = few ? fit_similarity(agreeing_) : fit_affine(agreeing_);
    if (!plausible(pose)) return {};
    gather(pairs, pose, settings_.fit_tolerance * side_px * (round == 0 ? 2.0 : 1.0));
  }
  return {distinct(), pose};
}

}  // namespace striate
