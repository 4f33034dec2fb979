#include "striate/platform/simulator/range_finders.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "striate/platform/interface/seen_from_axle.hpp"

namespace striate::simulator {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();  // m: no echo
constexpr double kFirePeriod_s = 0.040;  // one disc of an array each; P3-DX, SONARCYCLE's default
constexpr int kRaysPerBeam =
    7;  // 4 deg apart in a beam of 25: a chair's leg, 26 mm, is not missed up to 0.35 m
constexpr double kSonarNearest_m = 0.10;  // nearest that a disc of a P3-DX tells
/// A wall sends sound back where it stands square to the beam within 25 deg; edges, cloth and
/// cardboard scatter it within 70 deg.
const double kCosSmooth = std::cos(radians(25.0));
/// Edges, cloth and cardboard scatter sound within 70 deg (ours)
const double kCosRough = std::cos(radians(70.0));
/// Each array's discs fire far from the one before, against echoes of the neighbour.
constexpr std::array<std::size_t, kDiscsOfAnArray> kOrder{0, 5, 1, 4, 2, 7, 3, 6};
/// Standard deviation of an echo: 4 mm and 0.5 % of the way, as the speed of sound changes with
/// some degrees of temperature (ours).
constexpr double kEchoNoise_m = 0.004;
/// Share of the way that an echo errs by, see kEchoNoise_m.
constexpr double kEchoNoiseShare = 0.005;
/// Nearest that a URG-04LX tells (DMIN of its PP reply, 20 mm).
constexpr double kLaserNearest_m = 0.02;

/// The Pioneer's place, moved as far as the outline's ends are.
Pose2 mounted(const Pose2& place, const RobotDescription& robot) {
  const RobotDescription pioneer;
  const double along =
      place.x_m >= 0.0 ? robot.front_m / pioneer.front_m : robot.rear_m / pioneer.rear_m;
  const double aside = robot.half_width_m / pioneer.half_width_m;
  return {place.x_m * along, place.y_m * aside, place.heading_rad};
}

}  // namespace

std::vector<Pose2> sonar_mounts(const RobotDescription& robot) {
  if (!robot.sonar_discs.empty()) return robot.sonar_discs;
  std::vector<Pose2> mounts;
  for (const Pose2& disc : sonar_discs()) mounts.push_back(mounted(disc, robot));
  return mounts;
}

std::vector<std::size_t> discs_fired_at(TimePoint stamp, std::size_t arrays) {
  const auto fired = static_cast<std::size_t>(to_seconds(stamp) / kFirePeriod_s + 1e-6);
  std::vector<std::size_t> discs;
  for (std::size_t array = 0; array < arrays; ++array) {
    discs.push_back(kDiscsOfAnArray * array + kOrder[fired % kOrder.size()]);
  }
  return discs;
}

Pose2 laser_mount(const RobotDescription& robot) {
  return mounted({kLaserForward_m, 0.0, 0.0}, robot);
}

Sonar::Sonar(std::uint64_t seed, const SensorSettings& settings, const RobotDescription& robot)
    : random_(seed, Purpose::sonar), settings_(settings), mounts_(sonar_mounts(robot)) {
  for (const Pose2& pose : mounts_) scan_.readings.push_back(seen_from_axle(pose, kInfinity));
}

void Sonar::step(double now_s, const Physics& physics) {
  while (static_cast<double>(fired_) * kFirePeriod_s <= now_s + 1e-9) {
    const std::size_t disc = kOrder[fired_ % kOrder.size()];
    for (std::size_t first = 0; first + disc < mounts_.size(); first += kDiscsOfAnArray) {
      fire(first + disc, physics);
    }
    scan_.stamp = TimePoint(from_seconds(now_s));
    ++fired_;
  }
}

void Sonar::fire(std::size_t disc, const Physics& physics) {
  const Pose2& pose = mounts_[disc];
  const Pose2 outer = transform(physics.robot(), pose);
  double nearest = kInfinity;
  for (int i = 0; i < kRaysPerBeam; ++i) {
    const double offset = settings_.sonar_half_beam_rad * (2.0 * i / (kRaysPerBeam - 1) - 1.0);
    const RayHit hit = physics.ray({outer.x_m, outer.y_m}, outer.heading_rad + offset,
                                   settings_.sonar_range_m, Beam::sound);
    if (hit.cos_incidence < (hit.smooth ? kCosSmooth : kCosRough)) continue;
    nearest = std::min(nearest, hit.distance_m);
  }
  if (std::isfinite(nearest)) {
    const std::size_t numbers = std::max(kSonarDiscs, mounts_.size());
    nearest += (kEchoNoise_m + kEchoNoiseShare * nearest) * random_.normal(numbers * fired_ + disc);
    nearest = std::max(nearest, kSonarNearest_m);
  }
  scan_.readings[disc] = seen_from_axle(pose, nearest);
}

RangeScan Laser::sweep(TimePoint now, const Physics& physics) {
  RangeScan scan;
  scan.stamp = now;
  scan.readings.reserve(181);
  for (int degree = -90; degree <= 90; ++degree) {
    const double bearing = radians(degree);
    scan.readings.push_back(
        seen_from_axle({mount_.x_m, mount_.y_m, bearing}, range_m(bearing, physics)));
  }
  return scan;
}

double Laser::range_m(double bearing_rad, const Physics& physics) {
  const Pose2 outer = transform(physics.robot(), mount_);
  const std::uint64_t number = rays_++;
  const double distance = physics
                              .ray({outer.x_m, outer.y_m}, outer.heading_rad + bearing_rad,
                                   settings_.laser_range_m, Beam::light)
                              .distance_m;
  if (!std::isfinite(distance)) return distance;
  return std::max(kLaserNearest_m, distance + settings_.laser_noise_m * random_.normal(number));
}

}  // namespace striate::simulator
