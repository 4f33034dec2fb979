#include <algorithm>
#include <array>
#include <cmath>

#include "perception/stereo/decision.hpp"

namespace striate {
namespace {

/// The logistic function in steps of 1/1000, over scores in 1/64: rounded, so that it does not
/// depend on the last bit of the machine's mathematics library.
constexpr int kScoreUnit = 64;
constexpr int kScoreLimit = 8 * kScoreUnit;

std::array<float, 2 * kScoreLimit + 1> make_logistic() {
  std::array<float, 2 * kScoreLimit + 1> table{};
  for (int k = -kScoreLimit; k <= kScoreLimit; ++k) {
    const double p = 1.0 / (1.0 + std::exp(-static_cast<double>(k) / kScoreUnit));
    table[static_cast<std::size_t>(k + kScoreLimit)] =
        static_cast<float>(static_cast<double>(std::lround(p * 1000.0)) / 1000.0);
  }
  return table;
}

const std::array<float, 2 * kScoreLimit + 1> kLogistic = make_logistic();

}  // namespace

float stereo_confidence(const StereoEvidence& e) {
  const int score = -32 + e.margin * 5 / 8 - e.cost + e.texture / 200;
  return kLogistic[static_cast<std::size_t>(std::clamp(score, -kScoreLimit, kScoreLimit) +
                                            kScoreLimit)];
}

}  // namespace striate
