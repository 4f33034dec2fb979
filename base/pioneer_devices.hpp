#pragma once

#include <array>
#include <chrono>
#include <cstddef>

#include "striate/base/geometry.hpp"
#include "striate/base/time.hpp"

/// Where a Pioneer 3-DX's devices sit, from the middle of its axle: what the simulated and the real
/// one must agree on. Sonar: its operations manual; the rest measured for an LMS-2xx on a p3dx-sh.
namespace striate {

inline constexpr std::size_t kSonarDiscs = 16;

/// Where the discs of the two arrays of eight sit and look.
[[nodiscard]] inline const std::array<Pose2, kSonarDiscs>& sonar_discs() {
  constexpr auto at = [](double x_mm, double y_mm, double deg) {
    return Pose2{x_mm / 1000.0, y_mm / 1000.0, radians(deg)};
  };
  static constexpr std::array<Pose2, kSonarDiscs> discs{
      at(69, 136, 90),     at(114, 119, 50),     at(148, 78, 30),     at(166, 27, 10),
      at(166, -27, -10),   at(148, -78, -30),    at(114, -119, -50),  at(69, -136, -90),
      at(-157, -136, -90), at(-203, -119, -130), at(-237, -78, -150), at(-255, -27, -170),
      at(-255, 27, 170),   at(-237, 78, 150),    at(-203, 119, 130),  at(-157, 136, 90)};
  return discs;
}

/// A disc speaks every 320 ms; what is older than two turns says nothing.
inline constexpr Duration kSonarFresh = std::chrono::milliseconds(700);

/// The laser before the axle.
inline constexpr double kLaserForward_m = 0.021;

/// Between the eyes of the stereo head.
inline constexpr double kEyesApart_m = 0.12;

/// One step of a Dynamixel AX-12's encoder: 300 degrees in 1023 steps.
inline constexpr double kServoStep_rad = radians(300.0) / 1023.0;

/// One step of its speed: 0.111 turns a minute.
inline constexpr double kServoSpeedStep_rad_s = 0.111 * 2.0 * kPi / 60.0;

/// One count of the heading that the base reports.
inline constexpr double kHeadingCount_rad = 2.0 * kPi / 4096.0;

}  // namespace striate
