#include <algorithm>
#include <cmath>
#include <utility>

#include "striate/base/median.hpp"
#include "striate/perception/visual_odometry/motion_estimate.hpp"

namespace striate::perception {
namespace {

constexpr int kRefineSteps = 15;          // steps; usually five are enough
constexpr double kMedianOfChi3 = 2.366;   // median of chi squared with 3 degrees of freedom
constexpr double kAgreeChi3 = 11.345;     // its 99 % quantile: beyond it a sight does not agree
constexpr double kMeanBelowChi3 = 2.874;  // its mean where what lies beyond that is left out
constexpr double kRefinedStep = 1e-9;     // m or rad: no change that a camera could see

/// Squared noise, by the median of what the sights' residuals are: half of them may be wrong.
double squared_noise(std::vector<double> squared, double least_px) {
  return std::max(median_of(std::move(squared)) / kMedianOfChi3, least_px * least_px);
}

/// One step; the noise before it. What is far off does not count at all: more than half of the
/// sights may be wrong, and then no median knows what is noise.
bool step_once(std::span<const MotionSight> sights, const StereoEyes& eyes,
               const MotionEstimateSettings& settings, RigidMotion& motion, double& noise2,
               double& length) {
  std::vector<SightError> errors;
  std::vector<double> squared;
  for (const MotionSight& sight : sights) {
    SightError error;
    if (!judge_sight(sight, eyes, motion, error)) continue;
    if (error.squared > settings.agree_px * settings.agree_px) continue;
    errors.push_back(error);
    squared.push_back(error.squared);
  }
  noise2 = squared_noise(std::move(squared), settings.least_noise_px);
  StepEquations equations;
  for (const SightError& error : errors) {
    const double ratio = error.squared / (noise2 * kCauchyChi3);
    equations.add(error, eyes, 1.0 / (1.0 + ratio));
  }
  cv::Vec6d step;
  if (!equations.solve(step)) return false;
  motion = nudged(motion, step);
  length = cv::norm(step);
  return true;
}

/// Who agrees, and how sure the motion is: the information of those who agree, by the noise that
/// their residuals show.
bool judge_motion(std::span<const MotionSight> sights, const StereoEyes& eyes, double noise2,
                  const MotionEstimateSettings& settings, MotionEstimate& estimate) {
  const double most_squared = settings.agree_px * settings.agree_px;
  estimate.agrees.assign(sights.size(), 0);
  estimate.agreeing = 0;
  StepEquations equations;
  double sum = 0.0;
  for (std::size_t k = 0; k < sights.size(); ++k) {
    SightError error;
    if (!judge_sight(sights[k], eyes, estimate.now_from_then, error)) continue;
    if (error.squared > std::min(kAgreeChi3 * noise2, most_squared)) continue;
    estimate.agrees[k] = 1;
    ++estimate.agreeing;
    sum += error.squared;
    equations.add(error, eyes, 1.0);
  }
  constexpr double kNumbers = 6.0;  // of a motion: each takes a degree of freedom
  const double freedom = kMeanBelowChi3 * estimate.agreeing - kNumbers;
  if (!(freedom > 0.0)) return false;
  const double measured =
      std::max(sum / freedom, settings.least_noise_px * settings.least_noise_px);
  estimate.noise_px = std::sqrt(measured);
  if (!invert(equations.information, estimate.covariance)) return false;
  estimate.covariance = estimate.covariance * measured;
  return true;
}

}  // namespace

MotionEstimate refine_motion(std::span<const MotionSight> sights, const StereoEyes& eyes,
                             const RigidMotion& from, const MotionEstimateSettings& settings) {
  MotionEstimate estimate;
  estimate.now_from_then = from;
  double noise2 = 0.0, length = 1.0;
  for (int k = 0; k < kRefineSteps && length > kRefinedStep; ++k) {
    if (!step_once(sights, eyes, settings, estimate.now_from_then, noise2, length)) {
      return estimate;
    }
  }
  estimate.now_from_then = straightened(estimate.now_from_then);
  estimate.found = judge_motion(sights, eyes, noise2, settings, estimate);
  return estimate;
}

}  // namespace striate::perception
