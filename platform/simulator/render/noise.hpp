#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

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

struct Octaves {
  int cells = 8;  ///< across the tile, at the coarsest
  int count = 4;
  float fade = 0.5F;  ///< amplitude from octave to octave
};

/// Smooth noise over the unit tile, which repeats: a sum of octaves, about [-1, 1]. The values at
/// the corners of the cells are drawn once, since an image asks for each of them many times.
class FractalNoise {
 public:
  FractalNoise(Octaves octaves, std::uint32_t seed) {
    float amplitude = 1.0F;
    int cells = octaves.cells;
    for (int i = 0; i < octaves.count; ++i) {
      octaves_.emplace_back(cells, seed + static_cast<std::uint32_t>(i) * 77U, amplitude);
      total_ += amplitude;
      amplitude *= octaves.fade;
      cells *= 2;
    }
  }

  [[nodiscard]] float operator()(float x, float y) const {
    float sum = 0.0F;
    for (const Octave& octave : octaves_) sum += octave.amplitude * octave.at(x, y);
    return sum / total_;
  }

 private:
  struct Octave {
    Octave(int cells_across, std::uint32_t seed, float weight)
        : cells(cells_across), amplitude(weight) {
      const auto side = static_cast<std::uint32_t>(cells);
      corners.reserve(static_cast<std::size_t>(side) * side);
      for (std::uint32_t y = 0; y < side; ++y) {
        const std::uint32_t row = mix(y * 0x10001U + seed);
        for (std::uint32_t x = 0; x < side; ++x) {
          corners.push_back(uniform(mix(x * 0x9E3779B1U ^ row)) * 2.0F - 1.0F);
        }
      }
    }

    [[nodiscard]] int wrapped(int i) const {
      return i >= 0 && i < cells ? i : ((i % cells) + cells) % cells;
    }
    [[nodiscard]] float at(float tile_x, float tile_y) const {
      const float x = tile_x * static_cast<float>(cells);
      const float y = tile_y * static_cast<float>(cells);
      const float fx = std::floor(x);
      const float fy = std::floor(y);
      const int x0 = wrapped(static_cast<int>(fx));
      const int x1 = wrapped(static_cast<int>(fx) + 1);
      const float* upper = corners.data() + wrapped(static_cast<int>(fy)) * cells;
      const float* lower = corners.data() + wrapped(static_cast<int>(fy) + 1) * cells;
      const float u = x - fx;
      const float v = y - fy;
      const float su = u * u * (3.0F - 2.0F * u);
      const float sv = v * v * (3.0F - 2.0F * v);
      const float top = upper[x0] + (upper[x1] - upper[x0]) * su;
      const float low = lower[x0] + (lower[x1] - lower[x0]) * su;
      return top + (low - top) * sv;
    }

    int cells;
    float amplitude;
    std::vector<float> corners;  ///< cells x cells, [-1, 1]
  };

  std::vector<Octave> octaves_;
  float total_ = 0.0F;
};

}  // namespace striate::simulator::render
