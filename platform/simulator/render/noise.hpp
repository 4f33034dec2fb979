#pragma once

#include <array>
#include <cmath>
#include <cstdint>

/// Counter-based randomness: a value depends on its counters alone, not on what was drawn before,
/// so that frame n of seed s is the same everywhere and images may be made in any order.
namespace striate::simulator::render {

/// A good 32-bit mixer (Wellons' "lowbias32").
[[nodiscard]] inline std::uint32_t mix(std::uint32_t x) {
  x ^= x >> 16U;
  x *= 0x7FEB352DU;
  x ^= x >> 15U;
  x *= 0x846CA68BU;
  x ^= x >> 16U;
  return x;
}
[[nodiscard]] inline std::uint32_t mix(std::uint32_t a, std::uint32_t b) {
  return mix(a ^ mix(b + 0x9E3779B9U));
}
/// 64 bits of seed and 64 bits of counter to one key.
[[nodiscard]] inline std::uint32_t key_of(std::uint64_t seed, std::uint64_t counter) {
  const auto low = [](std::uint64_t v) { return static_cast<std::uint32_t>(v); };
  const auto high = [](std::uint64_t v) { return static_cast<std::uint32_t>(v >> 32U); };
  return mix(mix(low(seed), high(seed)), mix(low(counter), high(counter)));
}
/// [0, 1)
[[nodiscard]] inline float uniform(std::uint32_t hash) {
  return static_cast<float>(hash >> 8U) * (1.0F / 16777216.0F);
}

/// Quantiles of the normal distribution: a hash indexes it.
class GaussTable {
 public:
  static constexpr std::uint32_t kBits = 12;  ///< 4096 quantiles: the outermost is at 3.7 sigma
  GaussTable() {
    for (std::size_t i = 0; i < value_.size(); ++i) {
      value_[i] = static_cast<float>(quantile((static_cast<double>(i) + 0.5) / 4096.0));
    }
  }
  [[nodiscard]] float operator()(std::uint32_t hash) const { return value_[hash >> (32U - kBits)]; }
  [[nodiscard]] const float* values() const { return value_.data(); }

 private:
  /// Bisection on the error function: slow, exact, only at start.
  static double quantile(double p) {
    double low = -6.0;
    double high = 6.0;
    for (int i = 0; i < 40; ++i) {
      const double middle = (low + high) / 2.0;
      (0.5 * std::erfc(-middle / std::sqrt(2.0)) < p ? low : high) = middle;
    }
    return (low + high) / 2.0;
  }
  std::array<float, 1U << kBits> value_{};
};

/// Smooth noise in [-1, 1] that repeats after `period` cells each way.
[[nodiscard]] inline float value_noise(float x, float y, int period, std::uint32_t seed) {
  const float fx = std::floor(x);
  const float fy = std::floor(y);
  const auto wrap = [period](int i) {
    return static_cast<std::uint32_t>(((i % period) + period) % period);
  };
  const std::uint32_t x0 = wrap(static_cast<int>(fx));
  const std::uint32_t x1 = wrap(static_cast<int>(fx) + 1);
  const std::uint32_t y0 = wrap(static_cast<int>(fy)) * 0x10001U + seed;
  const std::uint32_t y1 = wrap(static_cast<int>(fy) + 1) * 0x10001U + seed;
  const float u = x - fx;
  const float v = y - fy;
  const float su = u * u * (3.0F - 2.0F * u);
  const float sv = v * v * (3.0F - 2.0F * v);
  const auto at = [](std::uint32_t a, std::uint32_t b) {
    return uniform(mix(a * 0x9E3779B1U ^ mix(b))) * 2.0F - 1.0F;
  };
  const float top = at(x0, y0) + (at(x1, y0) - at(x0, y0)) * su;
  const float low = at(x0, y1) + (at(x1, y1) - at(x0, y1)) * su;
  return top + (low - top) * sv;
}

struct Octaves {
  int cells = 8;  ///< across the tile, at the coarsest
  int count = 4;
  float fade = 0.5F;  ///< amplitude from octave to octave
};

/// Sum of octaves of `value_noise` over the unit tile; about [-1, 1].
[[nodiscard]] inline float fractal_noise(float x, float y, Octaves octaves, std::uint32_t seed) {
  float sum = 0.0F;
  float amplitude = 1.0F;
  float total = 0.0F;
  int cells = octaves.cells;
  for (int i = 0; i < octaves.count; ++i) {
    const auto c = static_cast<float>(cells);
    sum += amplitude * value_noise(x * c, y * c, cells, seed + static_cast<std::uint32_t>(i) * 77U);
    total += amplitude;
    amplitude *= octaves.fade;
    cells *= 2;
  }
  return sum / total;
}

}  // namespace striate::simulator::render
