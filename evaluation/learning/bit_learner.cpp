#include "striate/evaluation/learning/bit_learner.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "striate/evaluation/patch_methods.hpp"

namespace striate::evaluation {
namespace {

constexpr std::size_t kBits = 256;  ///< of a descriptor; the paper's number
/// Bits chosen from one list of candidates, which is slow to make (ours)
constexpr std::size_t kRefresh = 8;
/// With largest correlation, of which each bit is chosen; kBest are kept. Time (ours)
constexpr std::size_t kCandidates = 150, kBest = 10 * kCandidates;
/// Of the logistic weights, a bit: by e within 17 bits, below the distances' sigma of 22 (ours)
constexpr double kSteepness = 0.06;
/// Pairs that correlations are taken from: known to 1 % (1 / sqrt(n))
constexpr std::size_t kCorrelated = 10000;

struct Candidate {
  int first = 0, second = 0;
  float threshold = 0.0F;
  double score = 0.0;
};

class Learner {
 public:
  Learner(const std::vector<perception::PooledResponses>& patches,
          const std::vector<PatchPair>& pairs, std::uint64_t seed)
      : pairs_(pairs), votes_(pairs.size(), 0.0F), weights_(pairs.size()), random_(seed) {
    values_.resize(static_cast<Eigen::Index>(patches.size()), perception::kPooledValues);
    for (std::size_t k = 0; k < patches.size(); ++k) {
      double sum = 0.0;
      for (const std::int32_t value : patches[k]) sum += value;
      const double mean = std::max(1.0, std::floor(sum / perception::kPooledValues));
      for (int c = 0; c < perception::kPooledValues; ++c) {
        values_(static_cast<Eigen::Index>(k), c) =
            static_cast<float>(patches[k][static_cast<std::size_t>(c)] / mean);
      }
    }
    centred_ = values_.rowwise() - values_.colwise().mean();
    spread_ = centred_.transpose() * centred_ / static_cast<float>(patches.size());
    larger_.resize(patches.size());
  }

  LearnedBits learn() {
    LearnedBits learned;
    for (std::size_t bit = 0; bit < kBits; ++bit) {
      weigh();
      if (bit % kRefresh == 0) find_candidates();
      for (Candidate& candidate : candidates_) judge(candidate);
      const auto best = std::ranges::max_element(candidates_, {}, &Candidate::score);
      learned.bits.push_back(
          {best->first, best->second, static_cast<int>(std::lround(best->threshold * 1000.0F))});
      vote(*best);
      candidates_.erase(best);
    }
    std::vector<float> distances;
    for (const float vote : votes_) distances.push_back(-vote);
    learned.false_positives = false_positive_rate(pairs_, distances, 0.95);
    return learned;
  }

 private:
  /// Logistic weights around the vote that 95 % of the true pairs reach; true and false pairs
  /// weigh 1 each in all.
  void weigh() {
    std::vector<float> same;
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      if (pairs_[p].same) same.push_back(votes_[p]);
    }
    const auto at = same.begin() + static_cast<std::ptrdiff_t>(same.size() / 20);
    std::ranges::nth_element(same, at);
    double sums[2] = {0.0, 0.0};
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      const double margin = (votes_[p] - *at) * (pairs_[p].same ? 1.0 : -1.0);
      weights_[p] = static_cast<float>(1.0 / (1.0 + std::exp(kSteepness * margin)));
      sums[pairs_[p].same] += weights_[p];
    }
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
      weights_[p] /= static_cast<float>(sums[pairs_[p].same]);
    }
  }

  template <class T>
  void shuffle(std::vector<T>& list) {
    for (std::size_t k = 0; k + 1 < list.size(); ++k) {
      std::swap(list[k], list[k + random_(static_cast<unsigned>(list.size() - k))]);
    }
  }

  /// Weighted correlation of every two responses, true pairs less false ones.
  Eigen::MatrixXf correlation() {
    std::vector<std::size_t> chosen(pairs_.size());
    for (std::size_t p = 0; p < chosen.size(); ++p) chosen[p] = p;
    shuffle(chosen);
    chosen.resize(std::min(chosen.size(), kCorrelated));
    const auto count = static_cast<Eigen::Index>(chosen.size());
    Eigen::MatrixXf a(count, perception::kPooledValues), b(count, perception::kPooledValues);
    for (Eigen::Index k = 0; k < count; ++k) {
      const std::size_t p = chosen[static_cast<std::size_t>(k)];
      a.row(k) = centred_.row(pairs_[p].first) * (pairs_[p].same ? weights_[p] : -weights_[p]);
      b.row(k) = centred_.row(pairs_[p].second);
    }
    const Eigen::MatrixXf one_way = a.transpose() * b;
    return (one_way + one_way.transpose()) * 0.5F;
  }

  void find_candidates() {
    const Eigen::MatrixXf m = correlation();
    candidates_.clear();
    for (int i = 0; i < perception::kPooledValues; ++i) {
      for (int j = i + 1; j < perception::kPooledValues; ++j) {
        const float spread = spread_(i, i) + spread_(j, j) - 2.0F * spread_(i, j);
        if (spread < 1e-5F) continue;
        candidates_.push_back({i, j, 0.0F, (m(i, i) + m(j, j) - 2.0F * m(i, j)) / spread});
      }
    }
    std::ranges::stable_sort(candidates_, std::ranges::greater{}, &Candidate::score);
    if (candidates_.size() > kBest) candidates_.resize(kBest);
    shuffle(candidates_);
    if (candidates_.size() > kCandidates) candidates_.resize(kCandidates);
  }

  void judge(Candidate& candidate) {
    difference_ = values_.col(candidate.first) - values_.col(candidate.second);
    std::vector<float> order(difference_.data(), difference_.data() + difference_.size());
    candidate.score = -1e9;
    for (const double quantile : {0.25, 0.375, 0.5, 0.625, 0.75}) {
      const auto at =
          order.begin() + static_cast<std::ptrdiff_t>(quantile * static_cast<double>(order.size()));
      std::ranges::nth_element(order, at);
      for (std::size_t k = 0; k < larger_.size(); ++k) {
        larger_[k] = difference_(static_cast<Eigen::Index>(k)) > *at;
      }
      double score = 0.0;
      for (std::size_t p = 0; p < pairs_.size(); ++p) {
        score += agrees(p) == pairs_[p].same ? weights_[p] : -weights_[p];
      }
      if (score > candidate.score) candidate.score = score, candidate.threshold = *at;
    }
  }

  [[nodiscard]] bool agrees(std::size_t p) const {
    return larger_[static_cast<std::size_t>(pairs_[p].first)] ==
           larger_[static_cast<std::size_t>(pairs_[p].second)];
  }

  void vote(const Candidate& chosen) {
    difference_ = values_.col(chosen.first) - values_.col(chosen.second);
    for (std::size_t k = 0; k < larger_.size(); ++k) {
      larger_[k] = difference_(static_cast<Eigen::Index>(k)) > chosen.threshold;
    }
    for (std::size_t p = 0; p < pairs_.size(); ++p) votes_[p] += agrees(p) ? 1.0F : -1.0F;
  }

  const std::vector<PatchPair>& pairs_;
  std::vector<float> votes_, weights_;
  cv::RNG random_;
  Eigen::MatrixXf values_, centred_, spread_;
  Eigen::VectorXf difference_;
  std::vector<char> larger_;
  std::vector<Candidate> candidates_;
};

}  // namespace

LearnedBits learn_bits(const std::vector<perception::PooledResponses>& patches,
                       const std::vector<PatchPair>& pairs, std::uint64_t seed) {
  return Learner(patches, pairs, seed).learn();
}

}  // namespace striate::evaluation
