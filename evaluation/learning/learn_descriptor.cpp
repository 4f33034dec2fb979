#include "striate/evaluation/learning/learn_descriptor.hpp"

#include <fmt/format.h>

#include "striate/base/user_error.hpp"
#include "striate/evaluation/frame_pairs.hpp"
#include "striate/evaluation/learning/bit_learner.hpp"
#include "striate/evaluation/learning/synthetic_images.hpp"

namespace striate::evaluation {
namespace {

/// At most, so that no image outweighs the others (ours)
constexpr std::size_t kPairsOfAnImage = 150;
constexpr std::size_t kLeastPairs = 100;  // fewer than this teach nothing: correlations err by 10 %
/// About what is evaluated: hard pairs teach more than close ones.
constexpr FrameTolerance kTolerance{0.5, 0.45, 30.0};

PatchSet training_patches(const LearnOptions& options) {
  PatchSet set;
  for (int k = 0; k < options.pictures; ++k) {
    const std::uint64_t seed = options.seed * 100003U + static_cast<std::uint64_t>(k);
    const cv::Mat1b image = synthetic_image({640, 480}, seed);
    const SecondView view = second_view(image, seed);
    const auto pairs =
        frame_pairs(sift_frames(image), sift_frames(view.image), view.homography, kTolerance);
    add_pairs(image, view.image, pairs, kPairsOfAnImage, seed, set);
  }
  return set;
}

}  // namespace

std::string learn_descriptor(const LearnOptions& options) {
  const PatchSet set = training_patches(options);
  if (set.pairs.size() < kLeastPairs) {
    throw UserError("learn-descriptor: too few frames were found again; give more images");
  }
  perception::StriateDescriber describer(perception::StriateSettings{});
  const perception::DescribedFrame frame{0.5 * (kPatchSide_px - 1), 0.5 * (kPatchSide_px - 1),
                                         kPatchSide_px / kPatchSizes, 0.0};
  std::vector<perception::PooledResponses> pooled, one;
  for (int k = 0; k < set.count; ++k) {
    describer.prepare(set.patch(k));
    describer.pool({&frame, 1}, one);
    pooled.push_back(one.front());
  }
  const LearnedBits learned = learn_bits(pooled, set.pairs, options.seed);
  return perception::striate_table_text(
      learned.bits,
      fmt::format("# Striate's 256-bit descriptor: pooled responses compared (point * 16 + "
                  "channel), threshold in\n"
                  "# thousandths of the mean. Made by: striate learn-descriptor --picture-count {} "
                  "--seed {}\n"
                  "# {} patch pairs of made images; false positives on them at 95 % recall: "
                  "{:.2f} %\n",
                  options.pictures, options.seed, set.pairs.size(),
                  100.0 * learned.false_positives));
}

}  // namespace striate::evaluation
