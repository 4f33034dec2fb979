#include "striate/evaluation/places/orb_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <opencv2/calib3d.hpp>
#include <opencv2/features2d.hpp>
#include <optional>
#include <set>

#include "striate/evaluation/places/place_methods.hpp"

namespace striate::evaluation {
namespace {

using perception::Descriptor;
using perception::NearestTwo;

constexpr int kRounds = 10;           // after which few descriptors change their word (by hand)
constexpr int kDescriptorBits = 256;  // bits: ORB has 32 bytes (Rublee et al. 2011)

/// The nearest word of each descriptor.
std::vector<std::uint32_t> words_of(std::span<const Descriptor> descriptors,
                                    std::span<const Descriptor> words) {
  perception::DescriptorStore store;
  store.append(words);
  perception::HammingSearch search;
  std::vector<std::uint32_t> result;
  result.reserve(descriptors.size());
  for (const NearestTwo& nearest : search.nearest_two(descriptors, store)) {
    result.push_back(nearest.first);
  }
  return result;
}

bool bit_of(const Descriptor& descriptor, int bit) {
  return ((descriptor.words[static_cast<std::size_t>(bit / 64)] >> (bit % 64)) & 1U) != 0;
}

/// Each word becomes what most of its descriptors are; one without any stays.
void move_to_majority(std::span<const Descriptor> descriptors, std::span<const std::uint32_t> word,
                      std::vector<Descriptor>& words) {
  std::vector<std::array<int, kDescriptorBits>> ones(words.size());
  std::vector<int> members(words.size());
  for (std::size_t k = 0; k < descriptors.size(); ++k) {
    ++members[word[k]];
    for (int b = 0; b < kDescriptorBits; ++b) {
      ones[word[k]][static_cast<std::size_t>(b)] += bit_of(descriptors[k], b) ? 1 : 0;
    }
  }
  for (std::size_t w = 0; w < words.size(); ++w) {
    if (members[w] == 0) continue;
    words[w] = {};
    for (int b = 0; b < kDescriptorBits; ++b) {
      if (2 * ones[w][static_cast<std::size_t>(b)] > members[w]) {
        words[w].words[static_cast<std::size_t>(b / 64)] |= std::uint64_t{1} << (b % 64);
      }
    }
  }
}

/// Keypoints of one image.
struct OrbImage {
  std::vector<cv::Point2f> places;
  cv::Mat rows;  ///< a descriptor each, as OpenCV matches them
};

/// How many of two images' keypoints agree with one fundamental matrix.
int agreeing_keypoints(const OrbImage& a, const OrbImage& b) {
  constexpr float kRatio = 0.8F;        // of the distances, no unit: as Lowe (2004) chose it
  constexpr double kFit_px = 3.0;       // px: OpenCV's own default of findFundamentalMat
  constexpr double kSure = 0.99;        // a share, no unit: OpenCV's own default
  constexpr std::size_t kCarriers = 8;  // pairs that carry a fundamental matrix
  if (a.rows.rows < 2 || b.rows.rows < 2) return 0;
  std::vector<std::vector<cv::DMatch>> nearest;
  cv::BFMatcher(cv::NORM_HAMMING).knnMatch(a.rows, b.rows, nearest, 2);
  std::vector<cv::Point2f> of_a, of_b;
  for (const auto& two : nearest) {
    if (two.size() < 2 || two[0].distance >= kRatio * two[1].distance) continue;
    of_a.push_back(a.places[static_cast<std::size_t>(two[0].queryIdx)]);
    of_b.push_back(b.places[static_cast<std::size_t>(two[0].trainIdx)]);
  }
  if (of_a.size() < kCarriers) return 0;
  std::vector<unsigned char> agrees;
  const cv::Mat found = cv::findFundamentalMat(of_a, of_b, cv::FM_RANSAC, kFit_px, kSure, agrees);
  return found.empty() ? 0 : static_cast<int>(std::ranges::count(agrees, 1));
}

class OrbWordPlaces final : public PlaceMethod {
 public:
  explicit OrbWordPlaces(WordsVerified verified) : verified_(verified) {}
  [[nodiscard]] std::string name() const override {
    return verified_ == WordsVerified::yes ? "ORB words, verified" : "ORB words";
  }
  void see(const cv::Mat1b& grey) override {
    std::vector<cv::KeyPoint> points;
    OrbImage image;
    orb_->detectAndCompute(grey, {}, points, image.rows);
    cv::KeyPoint::convert(points, image.places);
    std::vector<Descriptor>& descriptors = descriptors_.emplace_back();
    for (int row = 0; row < image.rows.rows; ++row) {
      Descriptor& one = descriptors.emplace_back();
      std::memcpy(one.words.data(), image.rows.ptr(row), sizeof one.words);
    }
    images_.push_back(std::move(image));
  }
  void learn() override { bags_.emplace(descriptors_, kWords); }
  [[nodiscard]] PlaceGuess ask(int image, int before) override {
    std::vector<PlaceGuess> guesses;
    for (int k = 0; k < before; ++k) {
      guesses.push_back({k, bag_likeness(bags_->of(static_cast<std::size_t>(image)),
                                         bags_->of(static_cast<std::size_t>(k)))});
    }
    std::ranges::stable_sort(guesses, std::greater<>(), &PlaceGuess::score);
    if (guesses.empty() || verified_ == WordsVerified::no) {
      return guesses.empty() ? PlaceGuess{} : guesses.front();
    }
    if (guesses.size() > kVerified) guesses.resize(kVerified);
    for (PlaceGuess& guess : guesses) {
      guess.score = agreeing_keypoints(images_[static_cast<std::size_t>(image)],
                                       images_[static_cast<std::size_t>(guess.image)]);
    }
    const PlaceGuess best = *std::ranges::max_element(guesses, {}, &PlaceGuess::score);
    return best.score > 0.0 ? best : PlaceGuess{};
  }

 private:
  static constexpr int kKeypoints = 1000;       // keypoints: twice OpenCV's own 500
  static constexpr std::size_t kWords = 1000;   // by hand: some dozens for each image
  static constexpr std::size_t kVerified = 10;  // as many as the gist proposes

  WordsVerified verified_;
  cv::Ptr<cv::ORB> orb_ = cv::ORB::create(kKeypoints);
  std::vector<OrbImage> images_;
  std::vector<std::vector<Descriptor>> descriptors_;
  std::optional<WordBags> bags_;
};

}  // namespace

std::vector<Descriptor> learn_words(std::span<const Descriptor> descriptors, std::size_t words) {
  std::vector<Descriptor> centres;
  std::set<std::array<std::uint64_t, 4>> chosen;
  const std::size_t count = std::min(words, descriptors.size());
  for (std::size_t k = 0; k < count; ++k) {
    // Equal ones would stay equal: the next one that is new.
    for (std::size_t at = k * descriptors.size() / count; at < descriptors.size(); ++at) {
      if (!chosen.insert(descriptors[at].words).second) continue;
      centres.push_back(descriptors[at]);
      break;
    }
  }
  if (centres.empty()) return centres;
  for (int round = 0; round < kRounds; ++round) {
    move_to_majority(descriptors, words_of(descriptors, centres), centres);
  }
  return centres;
}

WordBags::WordBags(std::span<const std::vector<Descriptor>> images, std::size_t words) {
  std::vector<Descriptor> all;
  for (const auto& image : images) all.insert(all.end(), image.begin(), image.end());
  const std::vector<Descriptor> centres = learn_words(all, words);
  std::vector<int> images_with(centres.size());
  for (const auto& image : images) {
    WordBag& bag = bags_.emplace_back();
    if (centres.empty()) continue;
    for (const std::uint32_t word : words_of(image, centres)) bag[word] += 1.0;
    for (const auto& [word, count] : bag) ++images_with[word];
  }
  for (WordBag& bag : bags_) {
    double sum = 0.0;
    for (auto& [word, weight] : bag) {
      weight *= std::log(static_cast<double>(images.size()) / images_with[word]);
      sum += weight;
    }
    for (auto& [word, weight] : bag) weight = sum > 0.0 ? weight / sum : 0.0;
  }
}

double bag_likeness(const WordBag& a, const WordBag& b) {
  double common = 0.0;  // 1 - |a - b| / 2, where both have the sum 1
  for (const auto& [word, weight] : a) {
    const auto same = b.find(word);
    if (same != b.end()) common += std::min(weight, same->second);
  }
  return common;
}

std::unique_ptr<PlaceMethod> orb_word_places(WordsVerified verified) {
  return std::make_unique<OrbWordPlaces>(verified);
}

}  // namespace striate::evaluation
