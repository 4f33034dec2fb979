#include "striate/perception/visual_odometry/features.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace striate::perception {
namespace {

double bits_apart(const std::uint8_t* a, const std::uint8_t* b, int bytes) {
  int bits = 0;
  for (int k = 0; k < bytes; k += 8) {
    std::uint64_t x = 0, y = 0;
    std::memcpy(&x, a + k, 8);
    std::memcpy(&y, b + k, 8);
    bits += std::popcount(x ^ y);
  }
  return bits;
}

double bytes_apart(const std::uint8_t* a, const std::uint8_t* b, int bytes) {
  int sum = 0;
  for (int k = 0; k < bytes; ++k) {
    const int apart = static_cast<int>(a[k]) - static_cast<int>(b[k]);
    sum += apart * apart;
  }
  return std::sqrt(static_cast<double>(sum));
}

constexpr int kCellsAcross = 16;  // of the wider side: some 20 px of a small image (by hand)

}  // namespace

double descriptor_distance(const FeatureSet& a, std::size_t i, const FeatureSet& b, std::size_t j) {
  const std::size_t bytes = static_cast<std::size_t>(a.bytes);
  const std::uint8_t* x = a.descriptors.data() + i * bytes;
  const std::uint8_t* y = b.descriptors.data() + j * bytes;
  return a.metric == DescriptorMetric::hamming ? bits_apart(x, y, a.bytes)
                                               : bytes_apart(x, y, a.bytes);
}

std::vector<std::size_t> spread_evenly(const std::vector<Feature>& features, cv::Size image,
                                       int most) {
  std::vector<std::size_t> kept(features.size());
  for (std::size_t k = 0; k < kept.size(); ++k) kept[k] = k;
  if (static_cast<int>(features.size()) <= most) return kept;
  const double cell_px =
      std::max(1.0, std::max(image.width, image.height) / static_cast<double>(kCellsAcross));
  const int columns = static_cast<int>(image.width / cell_px) + 1;
  const auto cell = [&](std::size_t k) {
    const int x = static_cast<int>(std::max(0.0, features[k].u_px) / cell_px);
    const int y = static_cast<int>(std::max(0.0, features[k].v_px) / cell_px);
    return y * columns + std::min(x, columns - 1);
  };
  // Strongest first; then a feature's rank within its cell says in which turn it is given.
  std::ranges::stable_sort(kept, [&](std::size_t a, std::size_t b) {
    return features[a].response > features[b].response;
  });
  std::vector<int> given;
  std::vector<std::pair<int, std::size_t>> turns;
  for (const std::size_t k : kept) {
    const auto at = static_cast<std::size_t>(cell(k));
    if (at >= given.size()) given.resize(at + 1, 0);
    turns.emplace_back(given[at]++, k);
  }
  std::ranges::stable_sort(turns, {}, &std::pair<int, std::size_t>::first);
  turns.resize(static_cast<std::size_t>(std::max(0, most)));
  kept.clear();
  for (const auto& [turn, k] : turns) kept.push_back(k);
  std::ranges::sort(kept);
  return kept;
}

}  // namespace striate::perception
