#include <algorithm>
#include <array>
#include <cmath>

#include "striate/perception/visual_odometry/motion_estimate.hpp"

namespace striate::perception {
namespace {

constexpr int kGuessSteps = 6;  // Gauss-Newton steps of three sights: they converge or are useless
constexpr int kLeastGuesses = 16;  // guesses, however well the first ones agree (by hand)
constexpr double kLongStep = 3.0;  // m or rad: a guess that steps farther is lost (by hand)

/// Random numbers by seed and counter (splitmix64, Steele et al. 2014): the same sights give the
/// same guesses.
std::uint64_t guess_number(std::uint64_t counter) {
  std::uint64_t x = (counter + 1) * 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

std::array<std::size_t, 3> three_of(std::size_t count, std::uint64_t guess) {
  std::array<std::size_t, 3> chosen{};
  for (std::size_t k = 0, tries = 0; k < 3; ++tries) {
    chosen[k] = guess_number(guess * 64 + tries) % count;
    bool again = false;
    for (std::size_t i = 0; i < k; ++i) again = again || chosen[i] == chosen[k];
    if (!again || tries > 60) ++k;
  }
  return chosen;
}

/// The motion that three sights tell, from a first idea of it.
bool motion_of_three(std::span<const MotionSight> sights, const std::array<std::size_t, 3>& chosen,
                     const StereoEyes& eyes, RigidMotion& motion) {
  for (int step = 0; step < kGuessSteps; ++step) {
    StepEquations equations;
    for (const std::size_t k : chosen) {
      SightError error;
      if (!judge_sight(sights[k], eyes, motion, error)) return false;
      equations.add(error, eyes, 1.0);
    }
    cv::Vec6d change;
    if (!equations.solve(change)) return false;
    const double length = cv::norm(change);
    if (length > kLongStep * (1.0 + cv::norm(motion.way_m))) return false;
    motion = nudged(motion, change);
    constexpr double kSmallStep = 1e-4;  // m or rad: far below what three keypoints know
    if (length < kSmallStep) break;
  }
  return true;
}

/// What the sights lose by a motion: each at most 1 (MSAC, Torr and Zisserman 2000).
double loss_of(std::span<const MotionSight> sights, const StereoEyes& eyes,
               const RigidMotion& motion, double agree_px, double best) {
  double loss = 0.0;
  for (const MotionSight& sight : sights) {
    SightError error;
    loss += judge_sight(sight, eyes, motion, error)
                ? std::min(1.0, error.squared / (agree_px * agree_px))
                : 1.0;
    if (loss >= best) break;
  }
  return loss;
}

void mark_agreeing(std::span<const MotionSight> sights, const StereoEyes& eyes, double agree_px,
                   MotionEstimate& estimate) {
  estimate.agrees.assign(sights.size(), 0);
  estimate.agreeing = 0;
  for (std::size_t k = 0; k < sights.size(); ++k) {
    SightError error;
    if (!judge_sight(sights[k], eyes, estimate.now_from_then, error)) continue;
    if (error.squared > agree_px * agree_px) continue;
    estimate.agrees[k] = 1;
    ++estimate.agreeing;
  }
}

/// Guesses until one is made of right sights alone with the wanted certainty.
int guesses_needed(double right_share, const MotionEstimateSettings& settings) {
  const double all_right = right_share * right_share * right_share;
  if (all_right >= 1.0) return kLeastGuesses;
  if (all_right <= 0.0) return settings.most_guesses;
  const double needed = std::log(1.0 - settings.sure) / std::log(1.0 - all_right);
  return static_cast<int>(
      std::clamp<double>(std::ceil(needed), kLeastGuesses, settings.most_guesses));
}

}  // namespace

MotionEstimate find_motion(std::span<const MotionSight> sights, const StereoEyes& eyes,
                           const RigidMotion& from, const MotionEstimateSettings& settings) {
  MotionEstimate estimate;
  if (sights.size() < 3) return estimate;
  double best = static_cast<double>(sights.size());
  const auto try_motion = [&](const RigidMotion& motion) {
    const double loss = loss_of(sights, eyes, motion, settings.agree_px, best);
    if (loss >= best) return;
    best = loss;
    estimate.now_from_then = motion;
    estimate.found = true;
  };
  try_motion(from);
  int needed = settings.most_guesses;
  for (int guess = 0; guess < needed; ++guess) {
    const std::array<std::size_t, 3> chosen =
        three_of(sights.size(), static_cast<std::uint64_t>(guess));
    RigidMotion motion = from;
    if (!motion_of_three(sights, chosen, eyes, motion)) continue;
    const double before = best;
    try_motion(motion);
    if (best < before) {
      needed = guesses_needed(1.0 - best / static_cast<double>(sights.size()), settings);
    }
  }
  if (estimate.found) mark_agreeing(sights, eyes, settings.agree_px, estimate);
  return estimate;
}

}  // namespace striate::perception
