#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "striate/memory/localisation/localisation.hpp"
#include "striate/platform/simulator/dead_reckoning.hpp"

/// Round trips through a made corridor with landmarks at its walls: the truth is known, odometry is
/// the simulator's, sightings are made with the errors and the view of the real eye.
namespace striate::reference {

struct TripSettings {
  double length_m = 60.0;
  double half_width_m = 1.1;  ///< where the landmarks hang
  double spacing_m = 4.0;
  double speed_m_s = 0.5;
  double half_view_rad = 0.375;  ///< 43 degrees in all
  double nearest_m = 0.5;
  double farthest_m = 4.0;
  double recognised_share = 0.5;  ///< of the looks at a landmark in view
  double bearing_error_rad = 0.01;
  double disparity_error_px = 0.5;
  double disparity_metre_px = 24.4;
  double middle_error_m = 0.05;  ///< of what is taken for the middle, the same from each side
  double wrong_share = 0.03;     ///< of sightings that are taken for another landmark
  bool seen_from_behind = true;  ///< whether the way back recognises what the way out did
  double start_error_m = 0.1;    ///< of where a further trip starts
  double start_error_rad = 0.03;
};

struct TripResult {
  double odometry_error_m = 0.0;
  double memory_error_m = 0.0;
  double nees = 0.0;  ///< of the pose, three degrees of freedom
  bool located = false;
  int taken = 0;
  int rejected = 0;
};

/// One robot with one memory that drives trip after trip.
class TripDriver {
 public:
  TripDriver(const TripSettings& trip, const memory::LocalisationSettings& place,
             std::uint64_t seed)
      : trip_(trip), place_(place), seed_(seed) {
    int side = 1;
    for (double x_m = 2.0; x_m < trip.length_m + 3.0; x_m += trip.spacing_m, side = -side) {
      memory::Landmark one;
      one.id = static_cast<std::int64_t>(truth_.size()) + 1;
      truth_.push_back({x_m, side * trip.half_width_m});
      known_.landmarks.push_back(one);
    }
  }

  /// @param trips round trips in one mission; what was learned is known to the next
  TripResult drive(int trips = 1) {
    Run run(*this, ++missions_);
    for (int k = 0; k < trips; ++k) {
      run.go_to(trip_.length_m);
      run.turn();
      run.go_to(0.0);
      if (k + 1 < trips) run.turn();
    }
    keep(run.memory.take_news(0.0));
    return run.result();
  }

  [[nodiscard]] const std::vector<Point2>& truth() const { return truth_; }
  [[nodiscard]] const memory::MapKnowledge& known() const { return known_; }

 private:
  static constexpr double kStep_s = 0.01;
  static constexpr int kStepsACycle = 10;

  struct Run {
    Run(const TripDriver& driver, std::uint64_t mission)
        : world(driver),
          random(1000 * driver.seed_ + mission, simulator::Purpose::walk),
          wheels(1000 * driver.seed_ + mission, {}),
          memory(driver.place_) {
      if (mission > 1) {
        pose = {trip().start_error_m * normal(), trip().start_error_m * normal(),
                trip().start_error_rad * normal()};
      }
      start = pose;
      memory.know(driver.known_);
      for (std::size_t k = 0; k < world.truth_.size(); ++k) {
        for (auto& side : off) side.push_back({shift(), shift()});
      }
      cycle();
    }

    [[nodiscard]] const TripSettings& trip() const { return world.trip_; }
    double normal() { return random.normal(drawn++); }
    double uniform() { return random.uniform(drawn++); }
    double shift() { return trip().middle_error_m * normal(); }

    void go_to(double x_m) {
      const double side = x_m > pose.x_m ? 1.0 : -1.0;
      while (side * (x_m - pose.x_m) > 0.0) {
        // Keeps to the middle as if by the walls, weaving a little.
        const double wanted = (side > 0.0 ? 0.0 : std::numbers::pi) -
                              side * 0.4 * (pose.y_m - 0.15 * std::sin(0.5 * pose.x_m));
        const double turn = std::clamp(wrap_angle(wanted - pose.heading_rad), -0.5, 0.5);
        step(trip().speed_m_s, turn);
      }
    }

    void turn() {
      const double wanted = wrap_angle(pose.heading_rad + std::numbers::pi);
      while (std::abs(wrap_angle(wanted - pose.heading_rad)) > 0.02) step(0.0, 0.5);
    }

    void step(double forward_m_s, double turn_rad_s) {
      const double half = pose.heading_rad + turn_rad_s * kStep_s / 2.0;
      pose.x_m += forward_m_s * kStep_s * std::cos(half);
      pose.y_m += forward_m_s * kStep_s * std::sin(half);
      pose.heading_rad = wrap_angle(pose.heading_rad + turn_rad_s * kStep_s);
      wheels.step(kStep_s, forward_m_s, turn_rad_s);
      if (++steps % kStepsACycle == 0) cycle();
    }

    /// A image is a cycle old when it is understood.
    void cycle() {
      const Pose2 odometry = wheels.reported({}).pose;
      memory.move(odometry);
      if (imaged) {
        for (std::size_t k = 0; k < world.truth_.size(); ++k) look_at(k);
      }
      imaged = true;
      image_odometry = odometry;
      image_pose = pose;
    }

    void look_at(std::size_t landmark) {
      const std::size_t side = std::abs(image_pose.heading_rad) < std::numbers::pi / 2.0 ? 0 : 1;
      if (side == 1 && !trip().seen_from_behind) return;
      const Point2 middle = world.truth_[landmark];
      const Point2 seen = inverse_transform(
          image_pose,
          Point2{middle.x_m + off[side][landmark].x_m, middle.y_m + off[side][landmark].y_m});
      const double range_m = std::hypot(seen.x_m, seen.y_m);
      const double bearing_rad = std::atan2(seen.y_m, seen.x_m);
      if (range_m < trip().nearest_m || range_m > trip().farthest_m ||
          std::abs(bearing_rad) > trip().half_view_rad || uniform() > trip().recognised_share) {
        return;
      }
      const double disparity_px =
          trip().disparity_metre_px / range_m + trip().disparity_error_px * normal();
      memory::LandmarkSighting sighting;
      sighting.landmark = static_cast<std::int64_t>(landmark) + 1;
      if (uniform() < trip().wrong_share) {
        sighting.landmark =
            1 + static_cast<std::int64_t>(uniform() * static_cast<double>(world.truth_.size()));
      }
      sighting.bearing_rad = bearing_rad + trip().bearing_error_rad * normal();
      sighting.distance_m = trip().disparity_metre_px / disparity_px;
      sighting.disparity_metre_px = trip().disparity_metre_px;
      const memory::SightingVerdict look = memory.see(sighting, image_odometry);
      taken +=
          look == memory::SightingVerdict::taken || look == memory::SightingVerdict::placed ? 1 : 0;
      rejected += look == memory::SightingVerdict::rejected ? 1 : 0;
    }

    [[nodiscard]] TripResult result() const {
      TripResult result;
      const Pose2 believed = transform(start, wheels.reported({}).pose);
      result.odometry_error_m = std::hypot(believed.x_m - pose.x_m, believed.y_m - pose.y_m);
      const Pose2 estimated = memory.estimate().pose();
      const double e[3] = {estimated.x_m - pose.x_m, estimated.y_m - pose.y_m,
                           wrap_angle(estimated.heading_rad - pose.heading_rad)};
      result.memory_error_m = std::hypot(e[0], e[1]);
      result.nees = squared(e, memory.estimate().pose_covariance());
      result.located = memory.located();
      result.taken = taken;
      result.rejected = rejected;
      return result;
    }

    /// e^T P^-1 e by Cramer's rule.
    static double squared(const double (&e)[3], const memory::PoseCovariance& p) {
      const double c00 = p[4] * p[8] - p[5] * p[7];
      const double c01 = p[5] * p[6] - p[3] * p[8];
      const double c02 = p[3] * p[7] - p[4] * p[6];
      const double c11 = p[0] * p[8] - p[2] * p[6];
      const double c12 = p[1] * p[6] - p[0] * p[7];
      const double c22 = p[0] * p[4] - p[1] * p[3];
      const double all = p[0] * c00 + p[1] * c01 + p[2] * c02;
      return (e[0] * e[0] * c00 + e[1] * e[1] * c11 + e[2] * e[2] * c22 +
              2.0 * (e[0] * e[1] * c01 + e[0] * e[2] * c02 + e[1] * e[2] * c12)) /
             all;
    }

    const TripDriver& world;
    simulator::Random random;
    simulator::DeadReckoning wheels;
    memory::Localisation memory;
    std::uint64_t drawn = 0;
    std::vector<Point2> off[2];  ///< of the middle that is seen, way out and way back
    Pose2 pose;                  ///< the truth, frame of the first mission's start
    Pose2 start;
    long steps = 0;
    bool imaged = false;
    Pose2 image_odometry;
    Pose2 image_pose;
    int taken = 0;
    int rejected = 0;
  };

  void keep(const memory::MapNews& news) {
    for (const memory::MapNews::Position& one : news.positions) {
      known_.landmarks[static_cast<std::size_t>(one.landmark - 1)].position = one.at;
    }
    for (const memory::Route& route : news.routes) {
      std::erase_if(known_.routes, [&](const memory::Route& old) {
        return old.from == route.from && old.to == route.to;
      });
      known_.routes.push_back(route);
    }
  }

  TripSettings trip_;
  memory::LocalisationSettings place_;
  std::uint64_t seed_;
  std::uint64_t missions_ = 0;
  std::vector<Point2> truth_;
  memory::MapKnowledge known_;
};

}  // namespace striate::reference
