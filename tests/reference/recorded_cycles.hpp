#pragma once

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "striate/platform/replay/recording_codec.hpp"
#include "striate/platform/replay/recording_format.hpp"

/// Recordings for tests, with a value of its own in every field.
namespace striate::reference {

inline cv::Mat3b noisy_image(int width_px, int height_px, unsigned seed) {
  cv::Mat3b image(height_px, width_px);
  for (cv::Vec3b& pixel : image) {
    for (int c = 0; c < 3; ++c) {
      seed = seed * 1664525U + 1013904223U;
      pixel[c] = static_cast<std::uint8_t>(seed >> 24U);
    }
  }
  return image;
}

inline replay::RecordedSetup a_setup() {
  replay::RecordedSetup setup;
  setup.software = "striate 9.9";
  setup.task = "tasks/there.yaml";
  setup.task_files = {{"there.yaml", "striate: 1\n"}, {"parts/back.yaml", "striate: 1\n# b\n"}};
  setup.variables = {{"way", "12 m"}};
  setup.memory_known = true;
  setup.memory = {1, 2, 3};
  setup.robot_file = "r.yaml";
  setup.robot_text = "safety: {}\n";
  setup.settings = {{"a.b", "1"}, {"a.c", "2 m"}};
  setup.emergency_layer = false;
  setup.world = "w.yaml";
  setup.seed = 0xFFFF'FFFF'FFFF'FFFEULL;
  setup.robot.front_m = 0.123;
  setup.robot.max_tilt_rad = 0.456;
  setup.robot.cycle = Duration(77'000'001);
  return setup;
}

inline replay::RecordedCycle a_cycle(std::uint64_t number) {
  const auto n = static_cast<double>(number);
  const auto time = [&](std::int64_t k) {
    return TimePoint(Duration(k + 100'000'000 * static_cast<std::int64_t>(number)));
  };
  replay::RecordedCycle cycle;
  cycle.number = number;
  Senses& s = cycle.senses;
  s.now = time(1);
  s.stereo.stamp = time(2);
  s.stereo.left = noisy_image(32, 24, static_cast<unsigned>(number));
  s.stereo.right = noisy_image(32, 24, static_cast<unsigned>(number) + 1000);
  s.stereo.focal_px = 400.1 + n;
  s.stereo.centre_u_px = 15.5;
  s.stereo.centre_v_px = 11.25;
  s.stereo.baseline_m = 0.12;
  s.stereo.head = {0.1, -0.2};
  s.odometry = {time(3), {1.0 / 3.0, -2.0, 0.7}, 0.31, -0.0};
  s.sonar = {time(4), {{0.1, 1.5}, {0.2, std::numeric_limits<double>::infinity()}}};
  s.laser = {time(5), {{-1.5, 0.25}, {0.0, std::nan("")}, {1.5, 5e-324}}};
  s.head = {0.3, -0.4};
  s.battery_v = 12.25;
  s.bumper = number % 2 == 0;
  s.motors_stalled = number % 2 == 1;
  cycle.decision = {{0.5, 0.1, 0.2, 0.3},  2,           time(6), "goes round \xC3\xBC",
                    {0.4, -0.1, 0.0, 0.1}, "slow zone", "avoid", true};
  return cycle;
}

/// A closed recording of these cycles, with checksums that are right.
inline std::string recording_of(const replay::RecordedSetup& setup,
                                const std::vector<replay::RecordedCycle>& cycles) {
  std::vector<std::uint8_t> bytes = replay::file_head();
  replay::append_chunk(bytes, replay::Chunk::setup, replay::encode(setup));
  std::vector<std::uint8_t> payload;
  for (const replay::RecordedCycle& cycle : cycles) {
    replay::encode(cycle, false, payload);
    replay::append_chunk(bytes, replay::Chunk::cycle, payload);
  }
  payload.clear();
  ByteWriter(payload).put(std::uint64_t{0});
  replay::append_chunk(bytes, replay::Chunk::end, payload);
  return {bytes.begin(), bytes.end()};
}

/// A closed recording of so many cycles.
inline std::string a_recording(std::uint64_t cycles, bool closed = true) {
  std::vector<std::uint8_t> bytes = replay::file_head();
  replay::append_chunk(bytes, replay::Chunk::setup, replay::encode(a_setup()));
  std::vector<std::uint8_t> payload;
  for (std::uint64_t k = 1; k <= cycles; ++k) {
    replay::encode(a_cycle(k), false, payload);
    replay::append_chunk(bytes, replay::Chunk::cycle, payload);
  }
  if (closed) {
    payload.clear();
    ByteWriter(payload).put(std::uint64_t{7});
    replay::append_chunk(bytes, replay::Chunk::end, payload);
  }
  return {bytes.begin(), bytes.end()};
}

}  // namespace striate::reference
