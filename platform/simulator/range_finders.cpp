#include "platform/simulator/range_finders.hpp"

#include <cmath>
#include <limits>

namespace striate::simulator {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();  // m: no echo
constexpr double kFirePeriodS = 0.040;  // one disc of an array each; P3-DX, SONARCYCLE's default
constexpr int kRaysPerBeam =
    7;  // 4 deg apart in a beam of 25: a chair's leg, 26 mm, is not missed up to 0.35 m
constexpr double kSonarNearestM = 0.10;  // nearest that a disc of a P3-DX tells
/// A wall sends sound back where it stands square to the beam within 25 deg; edges, cloth and
/// cardboard scatter it within 70 deg.
const double kCosSmooth = std::cos(radians(25.0));
/// Edges, cloth and cardboard scatter sound within 70 deg (ours)
const double kCosRough = std::cos(radians(70.0));
/// Each array's discs fire far from the one before, against echoes of the neighbour.
constexpr std::array<std::size_t, 8> kOrder{0, 5, 1, 4, 2, 7, 3, 6};
constexpr double kLaserForwardM = 0.021;  // mount of an LMS-200 on a P3-DX (ARIA's p3dx-sh.p)

/// Standard deviation of an echo: 4 mm and 0.5 % of the way, as the speed of sound changes with
/// some degrees of temperature (ours).
constexpr double kEchoNoiseM = 0.004;
/// Share of the way that an echo errs by, see kEchoNoiseM.
constexpr double kEchoNoiseShare = 0.005;
/// Nearest that a URG-04LX tells (DMIN of its PP reply, 20 mm).
constexpr double kLaserNearestM = 0.02;

RangeReading from_axle(const Pose2& sensor, double distance_m) {
  const double reach = std::isfinite(distance_m) ? distance_m : 0.0;
  const Point2 hit = to_outer(sensor, Point2{reach, 0.0});
  if (!std::isfinite(distance_m)) return {sensor.heading_rad, kInfinity};
  return {std::atan2(hit.y_m, hit.x_m), std::hypot(hit.x_m, hit.y_m)};
}

}  // namespace

const std::array<Pose2, 16>& sonar_poses() {
  constexpr auto pose = [](double x_mm, double y_mm, double deg) {
    return Pose2{x_mm / 1000.0, y_mm / 1000.0, radians(deg)};
  };
  static constexpr std::array<Pose2, 16> poses{
      pose(69, 136, 90),     pose(114, 119, 50),     pose(148, 78, 30),     pose(166, 27, 10),
      pose(166, -27, -10),   pose(148, -78, -30),    pose(114, -119, -50),  pose(69, -136, -90),
      pose(-157, -136, -90), pose(-203, -119, -130), pose(-237, -78, -150), pose(-255, -27, -170),
      pose(-255, 27, 170),   pose(-237, 78, 150),    pose(-203, 119, 130),  pose(-157, 136, 90)};
  return poses;
}

std::array<std::size_t, 2> discs_fired_at(TimePoint stamp) {
  const auto fired = static_cast<std::size_t>(to_seconds(stamp) / kFirePeriodS + 1e-6);
  const std::size_t disc = kOrder[fired % kOrder.size()];
  return {disc, 8 + disc};
}

Pose2 laser_mount() {
  return {kLaserForwardM, 0.0, 0.0};
}

Sonar::Sonar(std::uint64_t seed, const SensorSettings& settings)
    : random_(seed, Purpose::sonar), settings_(settings) {
  for (const Pose2& pose : sonar_poses()) scan_.readings.push_back(from_axle(pose, kInfinity));
}

void Sonar::step(double now_s, const Physics& physics) {
  while (static_cast<double>(fired_) * kFirePeriodS <= now_s + 1e-9) {
    const std::size_t disc = kOrder[fired_ % kOrder.size()];
    fire(disc, physics);
    fire(8 + disc, physics);
    scan_.stamp = TimePoint(from_seconds(now_s));
    ++fired_;
  }
}

void Sonar::fire(std::size_t disc, const Physics& physics) {
  const Pose2& pose = sonar_poses()[disc];
  const Pose2 outer = to_outer(physics.robot(), pose);
  double nearest = kInfinity;
  for (int i = 0; i < kRaysPerBeam; ++i) {
    const double offset = settings_.sonar_half_beam_rad * (2.0 * i / (kRaysPerBeam - 1) - 1.0);
    const RayHit hit =
        physics.ray({outer.x_m, outer.y_m}, outer.heading_rad + offset, settings_.sonar_range_m);
    if (hit.cos_incidence < (hit.smooth ? kCosSmooth : kCosRough)) continue;
    nearest = std::min(nearest, hit.distance_m);
  }
  if (std::isfinite(nearest)) {
    nearest += (kEchoNoiseM + kEchoNoiseShare * nearest) * random_.normal(16 * fired_ + disc);
    nearest = std::max(nearest, kSonarNearestM);
  }
  scan_.readings[disc] = from_axle(pose, nearest);
}

RangeScan Laser::sweep(TimePoint now, const Physics& physics) {
  RangeScan scan;
  scan.stamp = now;
  scan.readings.reserve(181);
  const Pose2 mount = laser_mount();
  const Pose2 outer = to_outer(physics.robot(), mount);
  for (int degree = -90; degree <= 90; ++degree, ++rays_) {
    const double bearing = radians(degree);
    double distance =
        physics.ray({outer.x_m, outer.y_m}, outer.heading_rad + bearing, settings_.laser_range_m)
            .distance_m;
    if (std::isfinite(distance)) {
      distance =
          std::max(kLaserNearestM, distance + settings_.laser_noise_m * random_.normal(rays_));
    }
    scan.readings.push_back(from_axle({mount.x_m, mount.y_m, bearing}, distance));
  }
  return scan;
}

}  // namespace striate::simulator
