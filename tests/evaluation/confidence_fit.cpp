#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "striate/evaluation/learning/synthetic_stereo.hpp"
#include "striate/perception/stereo/gap_filling.hpp"
#include "striate/perception/stereo/stereo_matcher.hpp"

/// confidence_fit [scenes]: how often the robust setting's disparities are right (within 1 px, of
/// what both eyes see), by their score, and how often what fills small gaps is, on made scenes: the
/// tables kPromise (perception/stereo/confidence.cpp) and kGapTrust (gap_filling.hpp).
namespace striate {
namespace {

struct Share {
  double right = 0.0, of = 0.0;
  [[nodiscard]] double value() const { return of > 0.0 ? right / of : 0.0; }
};

bool is_right(float disparity_px, float truth_px) {
  return std::abs(disparity_px - truth_px) <= 1.0F;
}

/// Calls f(y, x) where both eyes see.
template <class F>
void for_judged(const evaluation::SyntheticPair& pair, const F& f) {
  for (int y = 0; y < pair.truth_px.rows; ++y) {
    for (int x = 0; x < pair.truth_px.cols; ++x) {
      if (std::isfinite(pair.truth_px(y, x))) f(y, x);
    }
  }
}

/// Scores around 0, 0.1, ... 1.
using ByScore = std::array<Share, 11>;

void add_scores(const evaluation::SyntheticPair& pair, const perception::DisparityMap& map,
                ByScore& shares) {
  for_judged(pair, [&](int y, int x) {
    if (map.disparity_px(y, x) == perception::kNoMatch) return;
    Share& share = shares[static_cast<std::size_t>(std::lround(10.0F * map.confidence(y, x)))];
    share.of += 1.0;
    share.right += is_right(map.disparity_px(y, x), pair.truth_px(y, x));
  });
}

using ByGap = std::array<std::array<Share, 3>, 3>;

/// One kind of gap at a time is filled.
void add_gaps(const evaluation::SyntheticPair& pair, const perception::DisparityMap& map,
              int longest_px, ByGap& shares) {
  for (std::size_t kind = 0; kind < 3; ++kind) {
    for (std::size_t length = 0; length < 3; ++length) {
      perception::GapTrust only{};
      only[kind][length] = 1.0F;
      perception::DisparityMap filled;
      map.disparity_px.copyTo(filled.disparity_px);
      map.confidence.copyTo(filled.confidence);
      perception::GapFilling(only).fill({longest_px, 0.0F}, filled);
      for_judged(pair, [&](int y, int x) {
        if (map.disparity_px(y, x) != perception::kNoMatch ||
            filled.disparity_px(y, x) == perception::kNoMatch)
          return;
        shares[kind][length].of += 1.0;
        shares[kind][length].right += is_right(filled.disparity_px(y, x), pair.truth_px(y, x));
      });
    }
  }
}

struct Fit {
  ByScore scores;
  ByGap gaps;
};

void add_scenes(cv::Size size, int scenes, Fit& fit) {
  perception::StereoSettings settings;
  settings.width = size.width;
  settings.robust.fill_gap_px = 0;
  const int longest_px = perception::StereoSettings{}.robust.fill_gap_px * size.width / 160;
  perception::StereoMatcher promises(settings);
  settings.robust.confidence = perception::StereoConfidence::score;
  settings.robust.least_confidence = 0.0;
  perception::StereoMatcher scores(settings);
  for (int k = 0; k < scenes; ++k) {
    const evaluation::SyntheticPair pair =
        evaluation::synthetic_stereo(size, static_cast<std::uint64_t>(k));
    add_scores(pair, scores.match(pair.left, pair.right), fit.scores);
    add_gaps(pair, promises.match(pair.left, pair.right), longest_px, fit.gaps);
  }
}

std::string mean(const Share& a, const Share& b) {
  return fmt::format("  {:.3f} ({:.2f}, {:.2f})", 0.5 * (a.value() + b.value()), a.value(),
                     b.value());
}

void print(const std::array<Fit, 2>& fits) {
  fmt::print("kPromises, scores 0, 0.1, ... 1:\n");
  for (std::size_t k = 0; k < fits[0].scores.size(); ++k) {
    fmt::print("{}\n", mean(fits[0].scores[k], fits[1].scores[k]));
  }
  fmt::print("kGapTrust: short, middle, long\n");
  for (std::size_t kind = 0; kind < 3; ++kind) {
    constexpr std::array kNames = {"surface", "step", "border"};
    fmt::print("  {:8}", kNames[kind]);
    for (std::size_t k = 0; k < 3; ++k) {
      fmt::print("{}", mean(fits[0].gaps[kind][k], fits[1].gaps[kind][k]));
    }
    fmt::print("\n");
  }
}

}  // namespace
}  // namespace striate

int main(int argc, char** argv) {
  using namespace striate;
  const int scenes = argc > 1 ? std::max(1, std::atoi(argv[1])) : 200;
  std::array<Fit, 2> fits;
  add_scenes({160, 120}, scenes, fits[0]);
  add_scenes({320, 240}, scenes, fits[1]);
  fmt::print("{} scenes; both sizes weigh alike (160x120, 320x240)\n", scenes);
  print(fits);
  return 0;
}
