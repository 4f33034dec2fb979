#include "striate/evaluation/odometry/pose_pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "striate/base/counted.hpp"
#include "striate/base/user_error.hpp"

namespace striate::evaluation {
namespace {

constexpr std::size_t kFewestPairs = 3;  // poses: fewer fix no rotation

double seconds_of(std::int64_t ns) {
  return 1e-9 * static_cast<double>(ns);
}

std::string span_text(const datasets::Trajectory& t) {
  return fmt::format("{:.3f} to {:.3f} s", seconds_of(t.poses.front().stamp_ns),
                     seconds_of(t.poses.back().stamp_ns));
}

void pair_by_count(const datasets::Trajectory& truth, const datasets::Trajectory& estimate,
                   PairedPoses& found) {
  // Stamps count the lines then, in seconds, so that a line that was left out shifts nothing.
  for (const datasets::TimedPose& pose : estimate.poses) {
    const auto same = std::ranges::lower_bound(
        truth.poses, pose.stamp_ns, {}, [](const datasets::TimedPose& p) { return p.stamp_ns; });
    if (same == truth.poses.end() || same->stamp_ns != pose.stamp_ns) {
      ++found.outside;
      continue;
    }
    found.pairs.push_back({*same, pose});
  }
  if (truth.poses.size() != estimate.poses.size()) {
    found.remarks.push_back(fmt::format("{} against {} of the truth: paired by their number",
                                        counted(estimate.poses.size(), "pose"),
                                        truth.poses.size()));
  }
}

void pair_by_time(const datasets::Trajectory& truth, const datasets::Trajectory& estimate,
                  const PairingSettings& settings, PairedPoses& found) {
  const auto offset_ns = static_cast<std::int64_t>(std::llround(1e9 * settings.offset_s));
  const auto gap_ns = static_cast<std::int64_t>(std::llround(1e9 * settings.most_gap_s));
  for (datasets::TimedPose pose : estimate.poses) {
    pose.stamp_ns += offset_ns;
    const auto after = std::ranges::lower_bound(
        truth.poses, pose.stamp_ns, {}, [](const datasets::TimedPose& p) { return p.stamp_ns; });
    if (after != truth.poses.end() && after->stamp_ns == pose.stamp_ns) {
      found.pairs.push_back({*after, pose});
      continue;
    }
    if (after == truth.poses.begin() || after == truth.poses.end()) {
      ++found.outside;
      continue;
    }
    const datasets::TimedPose& a = *(after - 1);
    const std::int64_t step_ns = after->stamp_ns - a.stamp_ns;
    if (step_ns > gap_ns) {
      ++found.in_gaps;
      continue;
    }
    const double share =
        static_cast<double>(pose.stamp_ns - a.stamp_ns) / static_cast<double>(step_ns);
    found.pairs.push_back({between(a, *after, share), pose});
  }
}

}  // namespace

datasets::TimedPose between(const datasets::TimedPose& a, const datasets::TimedPose& b,
                            double share) {
  datasets::TimedPose pose;
  pose.stamp_ns =
      a.stamp_ns +
      static_cast<std::int64_t>(std::llround(share * static_cast<double>(b.stamp_ns - a.stamp_ns)));
  pose.position_m = (1.0 - share) * a.position_m + share * b.position_m;
  const cv::Vec4d p = datasets::quaternion_of(a.rotation);
  cv::Vec4d q = datasets::quaternion_of(b.rotation);
  double along = p.dot(q);
  if (along < 0.0) {
    q = -q;
    along = -along;
  }
  const double angle_rad = std::acos(std::min(1.0, along));
  double of_p = 1.0 - share;
  double of_q = share;
  if (angle_rad > 1e-6) {  // below it the chord is the arc
    of_p = std::sin((1.0 - share) * angle_rad) / std::sin(angle_rad);
    of_q = std::sin(share * angle_rad) / std::sin(angle_rad);
  }
  pose.rotation = datasets::rotation_of(of_p * p + of_q * q);
  return pose;
}

PairedPoses pair_poses(const datasets::Trajectory& truth, const datasets::Trajectory& estimate,
                       const PairingSettings& settings) {
  PairedPoses found;
  if (!truth.timed && !estimate.timed) {
    pair_by_count(truth, estimate, found);
  } else if (truth.timed != estimate.timed) {
    throw UserError(fmt::format(
        "the {} has times and the {} has none\n    hint: KITTI's poses get theirs from times.txt: "
        "--times FILE",
        truth.timed ? "truth" : "estimate", truth.timed ? "estimate" : "truth"));
  } else {
    pair_by_time(truth, estimate, settings, found);
  }
  if (found.outside > 0) {
    found.remarks.push_back(fmt::format("{} of the estimate outside the time of the truth",
                                        counted(found.outside, "pose")));
  }
  if (found.in_gaps > 0) {
    found.remarks.push_back(fmt::format("{} in gaps of the truth longer than {:g} s",
                                        counted(found.in_gaps, "pose"), settings.most_gap_s));
  }
  if (found.pairs.size() >= kFewestPairs) return found;
  throw UserError(fmt::format(
      "too few poses belong together: {}, of {} and {} of the truth; the estimate goes from {}, "
      "the truth from {}\n    hint: are they of one run and one clock? --time-offset-s shifts the "
      "estimate, --most-gap-s bridges longer gaps",
      found.pairs.size(), estimate.poses.size(), truth.poses.size(), span_text(estimate),
      span_text(truth)));
}

}  // namespace striate::evaluation
