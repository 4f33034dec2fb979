#include "striate/perception/noise_estimate.hpp"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace striate::perception {
namespace {

/// Magnitude of a response: what the kernel has of one sign sums to 8
constexpr int kLargest = 4 * 255 * 2;
constexpr int kSaturated = kLargest + 1;  // what is black or white to the limit has lost its noise
using GreyHistogram = std::array<int, kSaturated + 1>;

/// Magnitudes of the responses in row v, without the first and the last pixel.
void respond(const cv::Mat1b& grey, int v, std::vector<std::int16_t>& magnitudes) {
  const uchar* above = grey[v - 1];
  const uchar* here = grey[v];
  const uchar* below = grey[v + 1];
  std::int16_t* to = magnitudes.data();
  for (int u = 1; u + 1 < grey.cols; ++u) {
    const int response = above[u - 1] - 2 * above[u] + above[u + 1] - 2 * here[u - 1] +
                         4 * here[u] - 2 * here[u + 1] + below[u - 1] - 2 * below[u] + below[u + 1];
    const bool saturated = here[u] == 0 || here[u] == 255;
    to[u - 1] = static_cast<std::int16_t>(saturated ? kSaturated : std::abs(response));
  }
}

/// In four histograms by turns: neighbours often fall into the same bin, and would wait for each
/// other.
GreyHistogram count(const cv::Mat1b& grey) {
  std::array<GreyHistogram, 4> turns{};
  std::vector<std::int16_t> magnitudes(static_cast<std::size_t>(grey.cols) - 2);
  for (int v = 1; v + 1 < grey.rows; ++v) {
    respond(grey, v, magnitudes);
    const std::size_t fours = magnitudes.size() / 4 * 4;
    for (std::size_t i = 0; i < fours; i += 4) {
      for (std::size_t k = 0; k < 4; ++k) ++turns[k][magnitudes[i + k]];
    }
    for (std::size_t i = fours; i < magnitudes.size(); ++i) ++turns[0][magnitudes[i]];
  }
  for (std::size_t k = 1; k < 4; ++k) {
    for (std::size_t b = 0; b < turns[k].size(); ++b) turns[0][b] += turns[k][b];
  }
  return turns[0];
}

}  // namespace

double estimate_noise(const cv::Mat1b& grey) {
  if (grey.rows < 3 || grey.cols < 3) return 0.0;
  const GreyHistogram histogram = count(grey);
  const int total = (grey.rows - 2) * (grey.cols - 2) - histogram[kSaturated];
  if (total == 0) return 0.0;
  int before = 0;
  int bin = 0;
  while (2 * (before + histogram[bin]) < total) before += histogram[bin++];
  // Inside the bin the median is interpolated; bin k holds magnitudes k - 1/2 .. k + 1/2.
  const double inside = (0.5 * total - before) / histogram[bin];
  const double median = bin == 0 ? 0.5 * inside : bin - 0.5 + inside;
  // Median of |x| for a normal x of sigma 1: its 75 % quantile
  constexpr double kMedianOfNormal = 0.6745;
  // Root of the sum of squares of (1 -2 1) x (1 -2 1): what it makes of noise of sigma 1
  constexpr double kKernelNorm = 6.0;
  return median / (kMedianOfNormal * kKernelNorm);
}

}  // namespace striate::perception
