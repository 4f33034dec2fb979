#include "perception/noise_estimate.hpp"

#include <cstdlib>
#include <vector>

namespace striate {

double estimate_noise(const cv::Mat1b& grey) {
  if (grey.rows < 3 || grey.cols < 3) return 0.0;
  constexpr int kLargest = 4 * 255 * 2;
  std::vector<int> histogram(kLargest + 1, 0);
  int total = 0;
  for (int v = 1; v + 1 < grey.rows; ++v) {
    const uchar* above = grey[v - 1];
    const uchar* here = grey[v];
    const uchar* below = grey[v + 1];
    for (int u = 1; u + 1 < grey.cols; ++u) {
      // What is black or white to the limit has lost its noise.
      if (here[u] == 0 || here[u] == 255) continue;
      const int response = above[u - 1] - 2 * above[u] + above[u + 1] - 2 * here[u - 1] +
                           4 * here[u] - 2 * here[u + 1] + below[u - 1] - 2 * below[u] +
                           below[u + 1];
      ++histogram[std::abs(response)];
      ++total;
    }
  }
  if (total == 0) return 0.0;
  int before = 0;
  int bin = 0;
  while (2 * (before + histogram[bin]) < total) before += histogram[bin++];
  // Inside the bin the median is interpolated; bin k holds magnitudes k - 1/2 .. k + 1/2.
  const double inside = (0.5 * total - before) / histogram[bin];
  const double median = bin == 0 ? 0.5 * inside : bin - 0.5 + inside;
  constexpr double kMedianOfNormal = 0.6745;
  constexpr double kKernelNorm = 6.0;
  return median / (kMedianOfNormal * kKernelNorm);
}

}  // namespace striate
