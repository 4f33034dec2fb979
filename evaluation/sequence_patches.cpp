#include "striate/evaluation/sequence_patches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>

#include "striate/base/user_error.hpp"
#include "striate/evaluation/images/set_files.hpp"
#include "striate/platform/datasets/images/read_image.hpp"

namespace striate::evaluation {
namespace {

namespace fs = std::filesystem;

/// The image of that name with any suffix; empty where there is none.
fs::path image_named(const fs::path& folder, const std::string& stem) {
  for (const fs::path& entry : sorted_entries(folder)) {
    if (entry.stem() == stem && datasets::is_image(entry)) return entry;
  }
  return {};
}

/// What one pair of images offers.
struct Offer {
  SequencePair pictures;
  std::vector<FramePair> frames;
};

/// How many each may give so that `wanted` come together: all alike, as far as they last.
std::size_t fair_share(const std::vector<Offer>& offers, std::size_t wanted) {
  std::size_t low = 0, high = wanted;
  while (low < high) {
    const std::size_t share = (low + high) / 2;
    std::size_t sum = 0;
    for (const Offer& offer : offers) sum += std::min(share, offer.frames.size());
    if (sum >= wanted)
      high = share;
    else
      low = share + 1;
  }
  return low;
}

}  // namespace

std::vector<fs::path> sorted_entries(const fs::path& folder) {
  std::vector<fs::path> entries;
  for (const auto& entry : fs::directory_iterator(folder)) entries.push_back(entry.path());
  std::ranges::sort(entries);
  return entries;
}

std::vector<SequencePair> image_pairs(const fs::path& folder) {
  std::vector<SequencePair> pairs;
  for (int k = 2; k <= 9; ++k) {
    for (const auto& [matrix, stem] : {std::pair{fmt::format("H1to{}p", k), std::string("img")},
                                       {fmt::format("H_1_{}", k), ""}}) {
      const fs::path path = folder / matrix;
      if (!fs::exists(path)) continue;
      const fs::path first = image_named(folder, stem + "1");
      const fs::path second = image_named(folder, fmt::format("{}{}", stem, k));
      if (first.empty() || second.empty()) {
        throw UserError(
            fmt::format("{}: its images {}1 and {}{} are missing", path.string(), stem, stem, k));
      }
      pairs.push_back({first, second, read_homography(path)});
    }
  }
  return pairs;
}

PatchSet from_sequences(const std::vector<SequencePair>& pictures, const PatchChoice& choice) {
  std::vector<Offer> offers;
  fs::path seen;
  std::vector<cv::KeyPoint> first;
  for (const SequencePair& pair : pictures) {
    if (pair.first != seen) first = sift_frames(datasets::read_any_grey(pair.first));
    seen = pair.first;
    offers.push_back({pair, frame_pairs(first, sift_frames(datasets::read_any_grey(pair.second)),
                                        pair.homography, choice.tolerance)});
  }
  const std::size_t share = fair_share(offers, static_cast<std::size_t>(choice.pairs));
  PatchSet set;
  std::size_t left = static_cast<std::size_t>(choice.pairs);
  std::uint64_t seed = choice.seed;
  for (const Offer& offer : offers) {
    const std::size_t most = std::min({share, left, offer.frames.size()});
    add_pairs(datasets::read_any_grey(offer.pictures.first),
              datasets::read_any_grey(offer.pictures.second), offer.frames, most, ++seed, set);
    left -= most;
  }
  return set;
}

}  // namespace striate::evaluation
