#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "striate/platform/simulator/scene.hpp"

/// Places all along a corridor from which perception is judged: offsets, headings, poses of the
/// head and people in the way, drawn by seed.
namespace striate::evaluation {

struct Pose {
  double along_m = 0.0;
  double left_m = 0.0;
  double heading_rad = 0.0;
  HeadPose head;
  bool person = false;
};

inline double unit_noise(std::uint64_t counter) {
  std::uint64_t z = (counter + 1) * 0x9E3779B97F4A7C15ULL;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) / 9007199254740992.0;
}

inline std::vector<Pose> poses_of(const simulator::World& world, std::uint64_t seed) {
  std::vector<Pose> poses;
  std::uint64_t n = 1000 * seed;
  for (double x = 1.0 + 0.1 * static_cast<double>(seed % 7); x < world.length_m - 3.0; x += 0.7) {
    Pose pose;
    pose.along_m = x;
    pose.left_m = (unit_noise(n++) - 0.5) * 0.5 * world.width_m;
    const double turn = unit_noise(n++) - 0.5;
    pose.heading_rad = turn * std::abs(turn) * 1.6;  // mostly small, up to 23 degrees
    constexpr double kTilts[] = {0.0, -0.1, -0.2, -0.3};
    constexpr double kPans[] = {0.0, 0.0, 0.0, 0.4, -0.4};
    pose.head.tilt_rad = kTilts[static_cast<int>(unit_noise(n++) * 4)];
    pose.head.pan_rad = kPans[static_cast<int>(unit_noise(n++) * 5)];
    pose.person = unit_noise(n++) < 0.25;
    poses.push_back(pose);
  }
  return poses;
}

inline simulator::SceneState scene_at(const simulator::FloorPlan& plan, const Pose& pose,
                                      std::uint64_t frame) {
  simulator::SceneState state;
  state.frame = frame;
  state.time_s = 0.1 * static_cast<double>(frame);
  state.robot = plan.at(pose.along_m, pose.left_m);
  state.robot.heading_rad = wrap_angle(state.robot.heading_rad + pose.heading_rad);
  state.head = pose.head;
  if (pose.person) {
    simulator::PersonState person;
    person.look = static_cast<int>(unit_noise(frame * 7 + 1) * 4);
    person.pose = plan.at(pose.along_m + 1.3 + 2.5 * unit_noise(frame * 7 + 2),
                          1.4 * (unit_noise(frame * 7 + 3) - 0.5));
    person.stride_rad = 6.0 * unit_noise(frame * 7 + 4);
    person.pose.heading_rad += 3.14 * unit_noise(frame * 7 + 5);
    state.people.push_back(person);
  }
  return state;
}

}  // namespace striate::evaluation
