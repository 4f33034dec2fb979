#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "striate/perception/v1/v1_settings.hpp"

/// The vector code of StriateDescriber, dispatched at run time; 16-bit integers throughout, the
/// same bits on every instruction set.
namespace striate::perception::pooling_kernels {

/// 11 px before the place and 13 behind: the outer circle (5.35) and its Gaussian's taps
inline constexpr int kWindowSide_px = 24;
/// Odd cells of 8 orientations, light and dark side
inline constexpr int kChannels = 2 * kOrientations;
/// Of 16 bits: 18 KiB, which stay in the first cache
inline constexpr int kWindowValues = kWindowSide_px * kWindowSide_px * kChannels;

/// The odd responses of a square of kWindowSide_px, at its upper left pixel.
struct OddWindow {
  std::array<const std::int16_t*, kOrientations> odd{};
  int stride = 0;
};

/// Largest absolute value in the window; at most 32767.
[[nodiscard]] std::int16_t largest_response(const OddWindow& window);

/// What the cells of a turned image would say: orientation i lies between i + quarter turns of
/// pi / 8 and the next.
struct Turn {
  int steps = 0;              ///< of pi / 8, 0..15
  std::int16_t fraction = 0;  ///< of the next step, in 1/32768
  std::int16_t factor = 1;    ///< of all responses; none may grow beyond 16 bits
};

/// Half-wave rectified: value (y * kWindowSide_px + x) * kChannels + c is [v_c]+ for c < 8 and
/// [-v_(c-8)]+ above. Only rows kFirstTurned_px .. kBehindTurned_px - 1, which are all that pools
/// reach; the others of `out` are left as they are.
void turn_window(const OddWindow& window, const Turn& turn, std::int16_t* out);
inline constexpr int kFirstTurned_px = 2;  ///< row of the window: the outermost pool's first tap
/// Row of the window behind the outermost pool's last tap
inline constexpr int kBehindTurned_px = 22;

/// A Gaussian as a product of two rows of taps, in 1/32768.
struct Pool {
  int first_pixel = 0;  ///< y * kWindowSide_px + x of its upper left tap
  int width = 0;        ///< taps across
  int height = 0;       ///< and down
  const std::int16_t* across = nullptr;
  const std::int16_t* down = nullptr;
};

/// @param window as turn_window() writes it. @param out kChannels values a pool.
void pool(const std::int16_t* window, std::span<const Pool> pools, std::int16_t* out);

}  // namespace striate::perception::pooling_kernels
