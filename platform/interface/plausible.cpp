#include "striate/platform/interface/plausible.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <utility>

namespace striate {
namespace {

// By hand, all of them: wider than anything that drives about in rooms has, and narrower than what
// makes the arithmetic behind them meaningless.

/// px; the longest side is that of the largest image that is read
constexpr int kShortestSide_px = 16;
constexpr int kLongestSide_px = 16384;
/// Times; a line camera is none
constexpr double kLongestShape = 8.0;
/// A telephoto lens, and a wide one; beyond it a flat image is mostly stretched corners
constexpr double kNarrowestView_rad = radians(4.0);
constexpr double kWidestView_rad = radians(150.0);
/// Image widths that the principal point may lie beside the middle: one off the chip is crooked
constexpr double kFarthestCentre = 1.5;
constexpr double kLeastBaseline_m = 0.001;
constexpr double kMostBaseline_m = 10.0;
/// Factor of focal length or baseline; calibrating changes them by some per cent
constexpr double kOtherCamera = 1.5;
/// rad; a head turns at most once round, either way
constexpr double kMostPan_rad = 2.0 * kPi;
constexpr double kMostTilt_rad = 0.5 * kPi;
/// A day's way at 1 m/s is 86 km
constexpr double kFarthest_m = 1e6;
constexpr double kMostHeading_rad = 1e6;
constexpr double kFastest_m_s = 100.0;
constexpr double kFastest_rad_s = 100.0;
constexpr double kMostBattery_v = 1000.0;
/// A laser that turns once round in steps of a hundredth of a degree has 36 000
constexpr std::size_t kMostReadings = 100'000;
/// Nanoseconds, 95 years: the difference of any two is a Duration, too
constexpr std::int64_t kLatest_ns = 3'000'000'000'000'000'000;
/// m; the shipped robots' outlines reach 0.3 m from the axle, the map 6.4 m
constexpr double kLargestRobot_m = 3.0;
constexpr double kMostSpeed = 100.0;  // m/s, rad/s, and these a second
constexpr double kLeastHeight_m = 0.01;
constexpr double kMostHeight_m = 100.0;
constexpr Duration kShortestCycle = std::chrono::milliseconds(1);
constexpr Duration kLongestCycle = std::chrono::seconds(10);

struct PlausibleNumber {
  const char* what;
  double value;
  double least;
  double most;
  const char* unit;
};

std::string first_beyond(std::initializer_list<PlausibleNumber> numbers) {
  for (const PlausibleNumber& n : numbers) {
    if (n.value >= n.least && n.value <= n.most) continue;  // false for what is no number
    return fmt::format("{} is {:.6g}{}; {:.6g} to {:.6g}{} can be used", n.what, n.value, n.unit,
                       n.least, n.most, n.unit);
  }
  return {};
}

std::string time_beyond(std::string_view what, TimePoint time) {
  const std::int64_t ns = time.time_since_epoch().count();
  if (ns >= -kLatest_ns && ns <= kLatest_ns) return {};
  return fmt::format("{} has a time of {} ns; at most {} can be used", what, ns, kLatest_ns);
}

std::string head_beyond(const HeadPose& head) {
  return first_beyond({{"the head's pan", head.pan_rad, -kMostPan_rad, kMostPan_rad, " rad"},
                       {"the head's tilt", head.tilt_rad, -kMostTilt_rad, kMostTilt_rad, " rad"}});
}

double view_of(const StereoFrame& frame) {
  return 2.0 * std::atan(0.5 * frame.left.cols / frame.focal_px);
}

std::string size_beyond(const StereoFrame& frame) {
  const int width = frame.left.cols;
  const int height = frame.left.rows;
  const int shorter = std::min(width, height);
  const int longer = std::max(width, height);
  if (shorter < kShortestSide_px || longer > kLongestSide_px || longer > kLongestShape * shorter) {
    return fmt::format(
        "the image is {} x {} px; sides of {} to {} px can be used, one at most {} "
        "times the other",
        width, height, kShortestSide_px, kLongestSide_px, kLongestShape);
  }
  if (!frame.right.empty() && frame.right.size() != frame.left.size()) {
    return fmt::format("the left image is {} x {} px, the right one {} x {}", width, height,
                       frame.right.cols, frame.right.rows);
  }
  return {};
}

std::string camera_beyond(const StereoFrame& frame) {
  const double width = frame.left.cols;
  if (!(frame.focal_px > 0.0) || !(view_of(frame) >= kNarrowestView_rad) ||
      view_of(frame) > kWidestView_rad) {
    return fmt::format(
        "the camera's focal length is {:.6g} px for images {} px wide; {:.4g} to "
        "{:.4g} px can be used",
        frame.focal_px, width, 0.5 * width / std::tan(0.5 * kWidestView_rad),
        0.5 * width / std::tan(0.5 * kNarrowestView_rad));
  }
  const double reach_px = kFarthestCentre * width;
  const double u_px = 0.5 * width;
  const double v_px = 0.5 * frame.left.rows;
  return first_beyond({{"the camera's principal point, u,", frame.centre_u_px, u_px - reach_px,
                        u_px + reach_px, " px"},
                       {"the camera's principal point, v,", frame.centre_v_px, v_px - reach_px,
                        v_px + reach_px, " px"},
                       {"the distance of its eyes", frame.right.empty() ? 1.0 : frame.baseline_m,
                        kLeastBaseline_m, kMostBaseline_m, " m"}});
}

std::string scan_beyond(const char* what, const RangeScan& scan) {
  if (scan.readings.size() > kMostReadings) {
    return fmt::format("{} has {} echoes; {} can be used", what, scan.readings.size(),
                       kMostReadings);
  }
  for (const RangeReading& echo : scan.readings) {
    // A distance that is no number is a beam that was not measured.
    if (std::isfinite(echo.bearing_rad) && !(echo.distance_m < 0.0)) continue;
    return fmt::format("{} has an echo at {:.6g} m, {:.6g} rad", what, echo.distance_m,
                       echo.bearing_rad);
  }
  return time_beyond(what, scan.stamp);
}

/// The first that is not empty.
template <class... Texts>
std::string first_of(Texts... texts) {
  std::string first;
  ((first.empty() ? void(first = std::move(texts)) : void()), ...);
  return first;
}

}  // namespace

std::string why_implausible(const StereoFrame& frame) {
  if (frame.left.empty()) return {};
  std::string size = size_beyond(frame);
  if (!size.empty()) return size;
  return first_of(camera_beyond(frame), head_beyond(frame.head),
                  time_beyond("the image", frame.stamp));
}

std::string why_implausible(const Senses& senses) {
  const Odometry& odometry = senses.odometry;
  return first_of(
      first_beyond(
          {{"the odometry's x", odometry.pose.x_m, -kFarthest_m, kFarthest_m, " m"},
           {"the odometry's y", odometry.pose.y_m, -kFarthest_m, kFarthest_m, " m"},
           {"the odometry's heading", odometry.pose.heading_rad, -kMostHeading_rad,
            kMostHeading_rad, " rad"},
           {"the odometry's speed", odometry.forward_m_s, -kFastest_m_s, kFastest_m_s, " m/s"},
           {"the odometry's turn", odometry.turn_rad_s, -kFastest_rad_s, kFastest_rad_s, " rad/s"},
           {"the battery", senses.battery_v, -kMostBattery_v, kMostBattery_v, " V"}}),
      head_beyond(senses.head), time_beyond("the body", senses.now),
      time_beyond("the odometry", odometry.stamp), scan_beyond("the sonar", senses.sonar),
      scan_beyond("the laser", senses.laser));
}

std::string why_implausible(const RobotDescription& robot) {
  std::string beyond = first_beyond({
      {"the robot's front", robot.front_m, 0.0, kLargestRobot_m, " m"},
      {"the robot's rear", robot.rear_m, 0.0, kLargestRobot_m, " m"},
      {"half of the robot's width", robot.half_width_m, 0.0, kLargestRobot_m, " m"},
      {"the robot's corner", robot.corner_m, 0.0, kLargestRobot_m, " m"},
      {"its fastest speed", robot.max_forward_m_s, 0.0, kMostSpeed, " m/s"},
      {"its fastest turn", robot.max_turn_rad_s, 0.0, kMostSpeed, " rad/s"},
      {"its acceleration", robot.max_acceleration_m_s2, 0.0, kMostSpeed, " m/s2"},
      {"its turn's acceleration", robot.max_turn_acceleration_rad_s2, 0.0, kMostSpeed, " rad/s2"},
      {"its camera's height", robot.camera_height_m, kLeastHeight_m, kMostHeight_m, " m"},
      {"its camera's place", robot.camera_forward_m, -kLargestRobot_m, kLargestRobot_m, " m"},
      {"its camera's view", robot.view_rad, kNarrowestView_rad, kWidestView_rad, " rad"},
      {"its head's rest", robot.resting_tilt_rad, -kMostTilt_rad, kMostTilt_rad, " rad"},
      {"its head's most pan", robot.max_pan_rad, 0.0, kMostPan_rad, " rad"},
      {"its head's most tilt", robot.max_tilt_rad, 0.0, kMostTilt_rad, " rad"},
  });
  if (!beyond.empty()) return beyond;
  if (robot.cycle >= kShortestCycle && robot.cycle <= kLongestCycle) return {};
  return fmt::format("its cycle takes {} ns; 1 ms to 10 s can be used", robot.cycle.count());
}

std::string why_of_another_camera(const StereoFrame& frame, double view_rad, double baseline_m) {
  const auto differs = [](double a, double b) {
    return !(a <= kOtherCamera * b) || !(b <= kOtherCamera * a);
  };
  const double focal_px = 0.5 * frame.left.cols / std::tan(0.5 * view_rad);
  if (differs(frame.focal_px, focal_px)) {
    return fmt::format(
        "the camera says a focal length of {:.6g} px for images {} px wide, a view "
        "of {:.3g} deg; it was told to have {:.3g} deg",
        frame.focal_px, frame.left.cols, degrees(view_of(frame)), degrees(view_rad));
  }
  if (baseline_m > 0.0 && differs(frame.baseline_m, baseline_m)) {
    return fmt::format(
        "the camera says that its eyes are {:.4g} m apart; it was told to have "
        "{:.4g} m",
        frame.baseline_m, baseline_m);
  }
  return {};
}

}  // namespace striate
