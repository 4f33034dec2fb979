#include "striate/evaluation/places/eval_places.hpp"

#include <algorithm>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <set>

#include "striate/evaluation/odometry/compare_odometry.hpp"

namespace striate::evaluation {

PlaceScore at_threshold(std::span<const PlaceQuestion> questions, double threshold) {
  PlaceScore score{.threshold = threshold};
  for (const PlaceQuestion& one : questions) {
    score.revisits += one.revisit ? 1 : 0;
    if (one.guess.image < 0 || one.guess.score < threshold) continue;
    ++score.claimed;
    score.right += one.right ? 1 : 0;
  }
  return score;
}

std::vector<PlaceScore> sweep_places(std::span<const PlaceQuestion> questions) {
  std::set<double, std::greater<>> thresholds;
  for (const PlaceQuestion& one : questions) {
    if (one.guess.image >= 0) thresholds.insert(one.guess.score);
  }
  std::vector<PlaceScore> scores;
  for (const double threshold : thresholds) scores.push_back(at_threshold(questions, threshold));
  return scores;
}

PlaceScore without_false(std::span<const PlaceQuestion> questions) {
  // Where the surest guess of all is false, nothing is found.
  PlaceScore best = at_threshold(questions, std::numeric_limits<double>::infinity());
  for (const PlaceScore& score : sweep_places(questions)) {
    if (score.right == score.claimed) best = score;
  }
  return best;
}

std::vector<PlaceRun> run_place_methods(datasets::Sequence& sequence,
                                        const PlaceEvalOptions& options,
                                        const std::vector<std::unique_ptr<PlaceMethod>>& methods,
                                        std::vector<PlacedImage>& images,
                                        const std::function<bool()>& stopped) {
  std::vector<PlaceRun> runs;
  for (const auto& method : methods) {
    runs.push_back({.name = method->name(), .questions = {}, .threshold = method->threshold()});
  }
  datasets::SequenceLook look;
  while (!(stopped && stopped()) && sequence.next(look)) {
    cv::Mat1b grey;
    cv::cvtColor(look.left, grey, cv::COLOR_BGR2GRAY);
    images.push_back({look.name, look.number, look.stamp_ns});
    for (std::size_t m = 0; m < methods.size(); ++m) {
      const double before_s = processor_s();
      methods[m]->see(grey);
      runs[m].ms += 1e3 * (processor_s() - before_s);
    }
  }
  const int count = static_cast<int>(images.size());
  for (std::size_t m = 0; m < methods.size() && !(stopped && stopped()); ++m) {
    methods[m]->learn();  // not in its time: it is done beforehand
    const double before_s = processor_s();
    for (int image = options.apart; image < count && !(stopped && stopped()); ++image) {
      runs[m].questions.push_back({.image = static_cast<std::size_t>(image),
                                   .guess = methods[m]->ask(image, image - options.apart + 1)});
    }
    runs[m].ms = (runs[m].ms + 1e3 * (processor_s() - before_s)) / std::max(1, count);
  }
  return runs;
}

void judge_places(const PlaceTruth& truth, const PlaceEvalOptions& options,
                  std::vector<PlaceRun>& runs) {
  for (PlaceRun& run : runs) {
    std::erase_if(run.questions,
                  [&](const PlaceQuestion& one) { return !truth.tells_of(one.image); });
    for (PlaceQuestion& one : run.questions) {
      const std::size_t before = one.image - static_cast<std::size_t>(options.apart) + 1;
      for (std::size_t k = 0; k < before && !one.revisit; ++k) {
        one.revisit = truth.same(one.image, k);
      }
      one.right =
          one.guess.image >= 0 && truth.same(one.image, static_cast<std::size_t>(one.guess.image));
    }
  }
}

}  // namespace striate::evaluation
