#pragma once

#include <cstdint>

/// Counter-based random numbers: the value depends on (seed, purpose, index) alone, never on who
/// asked before. Only integer arithmetic and exact scaling, so every machine draws the same.
namespace striate::simulator {

/// One stream for each use, so that a new use changes no other.
enum class Purpose : std::uint64_t {
  start_offset = 1,
  odometry,
  sonar,
  laser,
  image_loss,
  command_loss,
  walk,
  step_in_front,
  battery,
  line_faults,
  building,
};

class Random {
 public:
  Random(std::uint64_t seed, Purpose purpose)
      : key_(mix(seed * 0x9E3779B97F4A7C15ull + static_cast<std::uint64_t>(purpose))) {}

  /// 64 random bits.
  [[nodiscard]] std::uint64_t bits(std::uint64_t index) const {
    return mix(key_ ^ mix(index + 0xD1B54A32D192ED03ull));
  }
  /// In [0, 1).
  [[nodiscard]] double uniform(std::uint64_t index) const {
    return static_cast<double>(bits(index) >> 11) * 0x1.0p-53;
  }
  [[nodiscard]] double between(std::uint64_t index, double low, double high) const {
    return low + (high - low) * uniform(index);
  }
  /// Mean 0, deviation 1, never beyond 6: the sum of twelve 16 bit numbers, whose tails end
  /// early but which needs no logarithm that libraries round differently.
  [[nodiscard]] double normal(std::uint64_t index) const {
    double sum = 0.0;
    for (std::uint64_t word = 0; word < 3; ++word) {
      std::uint64_t b = bits(index * 3 + word + 0x8000000000000000ull);
      for (int part = 0; part < 4; ++part, b >>= 16) {
        sum += (static_cast<double>(b & 0xFFFF) + 0.5) * 0x1.0p-16;
      }
    }
    return sum - 6.0;
  }

 private:
  /// The finaliser of SplitMix64 (Steele, Lea, Flood 2014).
  [[nodiscard]] static std::uint64_t mix(std::uint64_t z) {
    z += 0x9E3779B97F4A7C15ull;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }
  std::uint64_t key_;
};

}  // namespace striate::simulator
