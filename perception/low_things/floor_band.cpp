#include "striate/perception/low_things/floor_band.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "striate/base/index_within.hpp"

namespace striate::perception {
namespace {

constexpr int kParts = 16;        // of a pixel: 0.06 px, a third of what a disparity errs by
constexpr int kWeightOne = 4096;  // scale of the weights: times the largest grey below 2^31
/// Largest fine grey: 255 in sixteenths (to_fine_working_size)
constexpr int kWhitest = 4080;

/// Weights of four neighbours for a place `part` sixteenths beyond the second.
std::array<int, 4> weights_at(int part) {
  const double t = static_cast<double>(part) / kParts;
  const double t2 = t * t;
  const double t3 = t2 * t;
  std::array<int, 4> weights{};
  weights[0] = static_cast<int>(std::lround(kWeightOne * 0.5 * (-t3 + 2.0 * t2 - t)));
  weights[2] = static_cast<int>(std::lround(kWeightOne * 0.5 * (-3.0 * t3 + 4.0 * t2 + t)));
  weights[3] = static_cast<int>(std::lround(kWeightOne * 0.5 * (t3 - t2)));
  weights[1] = kWeightOne - weights[0] - weights[2] - weights[3];
  return weights;
}

}  // namespace

void move_row(const std::uint16_t* from, int width, int sixteenths, std::uint16_t* to) {
  // Pixel x shows what was at x - sixteenths / 16: a whole pixel and some parts to its right.
  const int whole = -floor_within(-static_cast<double>(sixteenths) / kParts, -width, width);
  const int part = std::clamp(whole * kParts - sixteenths, 0, kParts - 1);
  const std::array<int, 4> weights = weights_at(part);
  for (int x = 0; x < width; ++x) {
    int sum = kWeightOne / 2;
    for (int k = 0; k < 4; ++k) {
      sum +=
          weights[static_cast<std::size_t>(k)] * from[std::clamp(x - whole - 1 + k, 0, width - 1)];
    }
    to[x] = static_cast<std::uint16_t>(std::clamp(sum / kWeightOne, 0, kWhitest));
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
        round_within(wanted_px * kParts, -kParts * left.cols, kParts * left.cols);
    move_row(right[v], left.cols, sixteenths, band.right[row]);
    band.moved_px.push_back(static_cast<double>(sixteenths) / kParts);
  }
  return band;
}

}  // namespace striate::perception
