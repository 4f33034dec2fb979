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

/// A winner that is hardly better than another disparity says nothing (sums of 8 paths).
constexpr int kLeastMargin = 8;
/// Responses of the strongest cell below 2^4 (its energy below 2^8), about a quarter of a grey
/// level, are no texture but the rounding of the picture.
constexpr int kLeastTexture = 8 * 2048;
/// Where a good match is as good elsewhere, the pixel itself does not tell the two apart: stripes,
/// a wall's even shading. What its neighbours say of it is not certain, however smooth. (Bad
/// matches are so in noise, where neighbours can be trusted: the regression knows them.)
constexpr int kGoodCost = 24;
constexpr float kMostIfAmbiguous = 0.45F;

/// What scores of 0, 0.1, ... 1 have kept: measured by `confidence_fit` (tests/evaluation) on made
/// scenes, none of which is evaluated, of 160x120 and 320x240.
constexpr std::array<double, 11> kPromises = {0.39, 0.53, 0.62, 0.69, 0.73, 0.76,
                                              0.79, 0.83, 0.87, 0.94, 0.985};

/// Of scores 0, 0.001, ... 1; linear between those of kPromises, rounded like the score.
std::array<float, 1001> make_promises() {
  std::array<float, 1001> table{};
  for (std::size_t k = 0; k < table.size(); ++k) {
    const std::size_t knot = std::min<std::size_t>(k / 100, kPromises.size() - 2);
    const double between = (static_cast<double>(k) - 100.0 * static_cast<double>(knot)) / 100.0;
    const double promise = kPromises[knot] + between * (kPromises[knot + 1] - kPromises[knot]);
    table[k] = static_cast<float>(static_cast<double>(std::lround(promise * 1000.0)) / 1000.0);
  }
  return table;
}

const std::array<float, 1001> kPromiseTable = make_promises();

}  // namespace

/// Logistic regression on 13 public pairs (those of stereo_table) in six states of light and
/// noise, from a clean picture to a tenth of the light, and on blank noisy walls, where every
/// disparity counts as wrong; default penalties, "right within 1.25 px" of the whole disparity,
/// after the left-right check. The margin of the sums adds nothing to these; what matters is the
/// smoothed sum beyond 8 times the raw cost, which smoothness paid because neighbours disagree.
float stereo_score(const StereoEvidence& e) {
  if (e.margin < kLeastMargin || e.texture < kLeastTexture) return 0.0F;
  const int score = 152 + 31 * e.cost / 4 + e.texture / 299 - 15 * e.sum / 14;
  const float confidence = kLogistic[static_cast<std::size_t>(
      std::clamp(score, -kScoreLimit, kScoreLimit) + kScoreLimit)];
  const bool ambiguous = e.raw_margin <= 0 && e.cost < kGoodCost;
  return ambiguous ? std::min(confidence, kMostIfAmbiguous) : confidence;
}

float promise_of(float score) {
  return kPromiseTable[static_cast<std::size_t>(
      std::lround(std::clamp(score, 0.0F, 1.0F) * 1000.0F))];
}

}  // namespace striate
