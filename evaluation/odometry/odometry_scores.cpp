#include "striate/evaluation/odometry/odometry_scores.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "striate/base/geometry.hpp"

namespace striate::evaluation {
namespace {

/// b in the frame of a.
datasets::TimedPose seen_from(const datasets::TimedPose& a, const datasets::TimedPose& b) {
  datasets::TimedPose seen;
  seen.stamp_ns = b.stamp_ns;
  seen.rotation = a.rotation.t() * b.rotation;
  seen.position_m = a.rotation.t() * (b.position_m - a.position_m);
  return seen;
}

/// Exact near 0 and near half a turn, where the trace alone is not.
double angle_of(const cv::Matx33d& r) {
  const cv::Vec4d q = datasets::quaternion_of(r);
  return 2.0 * std::atan2(cv::norm(cv::Vec3d(q[0], q[1], q[2])), q[3]);
}

/// Metres from the first true position, along the way.
std::vector<double> ways_of(const std::vector<PosePair>& pairs) {
  std::vector<double> ways(pairs.size(), 0.0);
  for (std::size_t k = 1; k < pairs.size(); ++k) {
    ways[k] = ways[k - 1] + cv::norm(pairs[k].truth.position_m - pairs[k - 1].truth.position_m);
  }
  return ways;
}

}  // namespace

MotionError motion_error(const PosePair& from, const PosePair& to) {
  const datasets::TimedPose truth = seen_from(from.truth, to.truth);
  const datasets::TimedPose estimate = seen_from(from.estimate, to.estimate);
  const datasets::TimedPose error = seen_from(estimate, truth);
  return {cv::norm(error.position_m), angle_of(error.rotation)};
}

ErrorFigures figures_of(std::vector<double> errors) {
  ErrorFigures figures;
  figures.count = errors.size();
  if (errors.empty()) return figures;
  std::ranges::sort(errors);
  double squares = 0.0;
  for (const double error : errors) {
    figures.mean += error / static_cast<double>(errors.size());
    squares += error * error;
  }
  figures.rmse = std::sqrt(squares / static_cast<double>(errors.size()));
  const std::size_t half = errors.size() / 2;
  figures.median = errors.size() % 2 == 1 ? errors[half] : 0.5 * (errors[half - 1] + errors[half]);
  figures.most = errors.back();
  return figures;
}

Alignment align(const std::vector<PosePair>& pairs, bool scale) {
  const double count = static_cast<double>(pairs.size());
  cv::Vec3d middle_of_truth{};
  cv::Vec3d middle_of_estimate{};
  for (const PosePair& pair : pairs) {
    middle_of_truth += pair.truth.position_m / count;
    middle_of_estimate += pair.estimate.position_m / count;
  }
  cv::Matx33d covariance = cv::Matx33d::zeros();
  double spread = 0.0;
  for (const PosePair& pair : pairs) {
    const cv::Vec3d y = pair.truth.position_m - middle_of_truth;
    const cv::Vec3d x = pair.estimate.position_m - middle_of_estimate;
    covariance += (y * x.t()) * (1.0 / count);
    spread += x.dot(x) / count;
  }
  cv::Matx33d u;
  cv::Matx31d w;
  cv::Matx33d vt;
  cv::SVD::compute(covariance, w, u, vt);
  cv::Matx33d sign = cv::Matx33d::eye();
  if (cv::determinant(u) * cv::determinant(vt) < 0.0) sign(2, 2) = -1.0;
  Alignment result;
  result.rotation = u * sign * vt;
  if (scale && spread > 0.0) {
    result.scale = (w(0) + w(1) + sign(2, 2) * w(2)) / spread;
  }
  result.way_m = middle_of_truth - result.scale * (result.rotation * middle_of_estimate);
  return result;
}

datasets::TimedPose aligned(const datasets::TimedPose& pose, const Alignment& by) {
  datasets::TimedPose result = pose;
  result.rotation = by.rotation * pose.rotation;
  result.position_m = by.scale * (by.rotation * pose.position_m) + by.way_m;
  return result;
}

std::vector<double> absolute_errors(const std::vector<PosePair>& pairs,
                                    const Alignment& alignment) {
  std::vector<double> errors;
  errors.reserve(pairs.size());
  for (const PosePair& pair : pairs) {
    errors.push_back(
        cv::norm(aligned(pair.estimate, alignment).position_m - pair.truth.position_m));
  }
  return errors;
}

RelativeErrors relative_errors(const std::vector<PosePair>& pairs, double over_s) {
  std::vector<double> ways;
  std::vector<double> turns;
  const auto over_ns = static_cast<std::int64_t>(std::llround(1e9 * over_s));
  std::size_t j = 0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const std::int64_t from_ns = pairs[i].estimate.stamp_ns;
    while (j < pairs.size() && pairs[j].estimate.stamp_ns - from_ns < over_ns) ++j;
    if (j == pairs.size()) break;
    if (pairs[j].estimate.stamp_ns - from_ns > over_ns + over_ns / 2) continue;  // across a gap
    const MotionError error = motion_error(pairs[i], pairs[j]);
    ways.push_back(error.way_m);
    turns.push_back(degrees(error.turn_rad));
  }
  return {figures_of(ways), figures_of(turns)};
}

double way_of(const std::vector<PosePair>& pairs) {
  return pairs.empty() ? 0.0 : ways_of(pairs).back();
}

std::vector<double> usual_lengths_m(double way_m) {
  std::vector<double> lengths;
  constexpr double kFirst_m = 100.0;  // m: KITTI's shortest stretch, and its step up to eight
  const bool long_enough = way_m > kFirst_m;
  for (int k = 1; k <= 8; ++k) {
    const double length_m = long_enough ? kFirst_m * k : 0.1 * way_m * k;
    if (length_m < way_m && length_m > 0.0) lengths.push_back(length_m);
  }
  return lengths;
}

KittiErrors kitti_errors(const std::vector<PosePair>& pairs, const std::vector<double>& lengths_m) {
  constexpr std::size_t kStep = 10;  // poses: the development kit's, one a second at 10 Hz
  const std::vector<double> ways = ways_of(pairs);
  KittiErrors result;
  for (const double length_m : lengths_m) {
    LengthErrors of_length{length_m, 0, 0.0, 0.0};
    for (std::size_t first = 0; first < pairs.size(); first += kStep) {
      const auto last = std::upper_bound(ways.begin() + static_cast<std::ptrdiff_t>(first),
                                         ways.end(), ways[first] + length_m);
      if (last == ways.end()) break;
      const auto at = static_cast<std::size_t>(last - ways.begin());
      const MotionError error = motion_error(pairs[first], pairs[at]);
      ++of_length.count;
      of_length.percent += 100.0 * error.way_m / length_m;
      of_length.deg_per_m += degrees(error.turn_rad) / length_m;
    }
    if (of_length.count == 0) continue;
    result.count += of_length.count;
    result.percent += of_length.percent;
    result.deg_per_m += of_length.deg_per_m;
    of_length.percent /= static_cast<double>(of_length.count);
    of_length.deg_per_m /= static_cast<double>(of_length.count);
    result.lengths.push_back(of_length);
  }
  if (result.count > 0) {
    result.percent /= static_cast<double>(result.count);
    result.deg_per_m /= static_cast<double>(result.count);
  }
  return result;
}

}  // namespace striate::evaluation
