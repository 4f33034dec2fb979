#include <algorithm>
#include <array>
#include <cmath>

#include "striate/perception/stereo/decision.hpp"

namespace striate::perception {
namespace {

/// The logistic function in steps of 1/1000, over scores in 1/64: rounded, so that it does not
/// depend on the last bit of the machine's mathematics library.
constexpr int kScoreUnit = 64;
/// Beyond 8 the logistic rounds to 0 or 1 at a thousandth (exp(-8) = 0.0003)
constexpr int kScoreLimit = 8 * kScoreUnit;

using ScoreTable = std::array<float, 2 * kScoreLimit + 1>;

ScoreTable make_logistic() {
  ScoreTable table{};
  for (int k = -kScoreLimit; k <= kScoreLimit; ++k) {
    const double p = 1.0 / (1.0 + std::exp(-static_cast<double>(k) / kScoreUnit));
    table[static_cast<std::size_t>(k + kScoreLimit)] =
        static_cast<float>(static_cast<double>(std::lround(p * 1000.0)) / 1000.0);
  }
  return table;
}

const ScoreTable kLogistic = make_logistic();  // of scores from -8 to 8

/// A winner that is hardly better than another disparity says nothing (sums of 8 paths).
/// Sums of 8 paths, one bit each: a winner hardly better than another disparity says nothing
constexpr int kLeastMargin = 8;
/// Responses of the strongest cell below 2^4 (its energy below 2^8), about a quarter of a grey
/// level, are no texture but the rounding of the image.
constexpr int kLeastTexture = 8 * 2048;
/// What both sensors or their lenses add at the same pixel (fixed pattern noise, blocks of JPEG,
/// dust) matches perfectly, at disparity 0: there responses below 2^8.5 (energy 2^17), about six
/// grey levels, are no texture. What is really so far away and so weak becomes unknown with it.
constexpr int kLeastTextureAtZero = 17 * 2048;
/// Where a good match is as good elsewhere, the pixel itself does not tell the two apart: stripes,
/// a wall's even shading. What its neighbours say of it is not certain, however smooth. (Bad
/// matches are so in noise, where neighbours can be trusted: the regression knows them.)
constexpr int kGoodCost = 24;  // of 256 bits: below a tenth differ (ours)
/// A score just under one half: rather wrong than right to the regression (ours)
constexpr float kMostIfAmbiguous = 0.45F;

/// What scores of 0, 0.1, ... 1 have kept: measured by `confidence_fit` (tests/evaluation) on made
/// scenes, none of which is evaluated, of 160x120 and 320x240.
constexpr std::array<double, 11> kPromises = {0.39, 0.53, 0.62, 0.69, 0.73, 0.76,
                                              0.79, 0.83, 0.87, 0.94, 0.985};

/// Promises of all that kLogistic may say.
ScoreTable make_promises() {
  ScoreTable table{};
  std::ranges::transform(kLogistic, table.begin(), promise_of);
  return table;
}
const ScoreTable kPromise = make_promises();  // of all that kLogistic may say
/// What kMostIfAmbiguous promises
const float kMostPromiseIfAmbiguous = promise_of(kMostIfAmbiguous);

}  // namespace

/// Logistic regression on 13 public pairs (those of stereo_table) in six states of light and
/// noise, from a clean image to a tenth of the light, and on blank noisy walls, where every
/// disparity counts as wrong; default penalties, "right within 1.25 px" of the whole disparity,
/// after the left-right check. The margin of the sums adds nothing to these; what matters is the
/// smoothed sum beyond 8 times the raw cost, which smoothness paid because neighbours disagree.
float stereo_confidence(const StereoEvidence& e, StereoConfidence measure) {
  const int least_texture = e.disparity_px == 0 ? kLeastTextureAtZero : kLeastTexture;
  if (e.margin < kLeastMargin || e.texture < least_texture) return 0.0F;
  const int score = 152 + 31 * e.cost / 4 + e.texture / 299 - 15 * e.sum / 14;
  const auto at =
      static_cast<std::size_t>(std::clamp(score, -kScoreLimit, kScoreLimit) + kScoreLimit);
  const bool ambiguous = e.raw_margin <= 0 && e.cost < kGoodCost;
  const bool bare = measure == StereoConfidence::score;
  const float confidence = bare ? kLogistic[at] : kPromise[at];
  if (!ambiguous) return confidence;
  return std::min(confidence, bare ? kMostIfAmbiguous : kMostPromiseIfAmbiguous);
}

/// Linear between those of kPromises, rounded like the score.
float promise_of(float score) {
  const double tenths = 10.0 * static_cast<double>(std::clamp(score, 0.0F, 1.0F));
  const std::size_t knot = std::min(static_cast<std::size_t>(tenths), kPromises.size() - 2);
  const double between = tenths - static_cast<double>(knot);
  const double promise = kPromises[knot] + between * (kPromises[knot + 1] - kPromises[knot]);
  return static_cast<float>(static_cast<double>(std::lround(promise * 1000.0)) / 1000.0);
}

}  // namespace striate::perception
