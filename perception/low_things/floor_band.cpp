#include "striate/perception/low_things/floor_band.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "striate/base/index_within.hpp"
#include "striate/perception/stereo/cubic_weights.hpp"

namespace striate::perception {

void move_row(const std::uint16_t* from, int width, int sixteenths, std::uint16_t* to) {
  // Pixel x shows what was at x - sixteenths / 16: a whole pixel and some parts to its right.
  const int whole = -floor_within(-static_cast<double>(sixteenths) / kCubicParts, -width, width);
  const int part = std::clamp(whole * kCubicParts - sixteenths, 0, kCubicParts - 1);
  const std::array<int, 4> weights = cubic_weights(part);
  for (int x = 0; x < width; ++x) {
    int sum = kCubicOne / 2;
    for (int k = 0; k < 4; ++k) {
      sum +=
          weights[static_cast<std::size_t>(k)] * from[std::clamp(x - whole - 1 + k, 0, width - 1)];
    }
    to[x] = static_cast<std::uint16_t>(std::clamp(sum / kCubicOne, 0, kWhitestFine));
  }
}

FloorBand cut_floor_band(const cv::Mat1w& left, const cv::Mat1w& right,
                         const ViewGeometry& geometry, int first_row, double floor_px) {
  FloorBand band;
  band.first_row = std::max(0, first_row);
  const int rows = left.rows - band.first_row;
  if (rows <= 0) return band;
  band.left = left.rowRange(band.first_row, left.rows).clone();
  band.right.create(rows, left.cols);
  band.moved_px.reserve(static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) {
    const int v = band.first_row + row;
    const double wanted_px = geometry.floor_disparity_px(v) - floor_px;
    const int sixteenths =
        round_within(wanted_px * kCubicParts, -kCubicParts * left.cols, kCubicParts * left.cols);
    move_row(right[v], left.cols, sixteenths, band.right[row]);
    band.moved_px.push_back(static_cast<double>(sixteenths) / kCubicParts);
  }
  return band;
}

}  // namespace striate::perception
