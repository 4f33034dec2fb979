#pragma once

#include <cmath>

/// Whole numbers from real ones that came from outside: a conversion of what does not fit is
/// undefined in C++, and an index outside of its range is another's memory. Within the range the
/// results are those of the plain conversions, bit for bit.
namespace striate {

/// Whole cells, bins and pixels of places in the world stay this far from the ends of an int, so
/// that sums and differences of two of them fit: 27 000 km at 5 cm.
inline constexpr int kFarthestCell = 1 << 29;

/// `value` without its fraction, held within `least` .. `most`; not a number: `least`.
[[nodiscard]] inline int cut_within(double value, int least, int most) {
  if (!(value > least)) return least;
  return value < most ? static_cast<int>(value) : most;
}

/// The whole number below `value`, held within `least` .. `most`; not a number: `least`.
[[nodiscard]] inline int floor_within(double value, int least, int most) {
  return cut_within(std::floor(value), least, most);
}

/// The whole number above `value`, held within `least` .. `most`; not a number: `least`.
[[nodiscard]] inline int ceil_within(double value, int least, int most) {
  return cut_within(std::ceil(value), least, most);
}

/// The nearest whole number, halves away from zero as by std::lround, held within `least` ..
/// `most`; not a number: `least`.
[[nodiscard]] inline int round_within(double value, int least, int most) {
  return cut_within(std::round(value), least, most);
}

/// The cell of a grid that is not bounded itself: the whole number below `value`.
[[nodiscard]] inline int cell_below(double value) {
  return floor_within(value, -kFarthestCell, kFarthestCell);
}

/// The nearest whole number, of a place that may lie anywhere, in the image or far outside of it.
[[nodiscard]] inline int nearest_cell(double value) {
  return round_within(value, -kFarthestCell, kFarthestCell);
}

}  // namespace striate
