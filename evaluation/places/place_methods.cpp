#include "striate/evaluation/places/place_methods.hpp"

#include <cstdlib>

#include "striate/perception/places/place_recogniser.hpp"

namespace striate::evaluation {
namespace {

class StriatePlaces final : public PlaceMethod {
 public:
  explicit StriatePlaces(int neighbours) : neighbours_(neighbours) {}
  [[nodiscard]] std::string name() const override { return "Striate"; }
  void see(const cv::Mat1b& grey) override { first_seen_.push_back(places_.add(eye_.look(grey))); }
  [[nodiscard]] PlaceGuess ask(int image, int before) override {
    const perception::PlaceAnswer answer = places_.find(
        places_.view(image), [&](int place) { return place < before; },
        [&](int a, int b) { return std::abs(first_seen(a) - first_seen(b)) <= neighbours_; });
    if (answer.matches.empty() || answer.matches.front().evidence <= 0.0) return {};
    const int best = answer.matches.front().place;
    // What was known again is no place of its own: the next time the two do not contend.
    if (answer.verdict == perception::PlaceVerdict::known) first_seen(image) = first_seen(best);
    return {best, answer.confidence};
  }
  [[nodiscard]] std::optional<double> threshold() const override { return 0.5; }

 private:
  [[nodiscard]] int& first_seen(int image) { return first_seen_[static_cast<std::size_t>(image)]; }

  int neighbours_;
  perception::PlaceEye eye_;
  perception::PlaceRecogniser places_;
  std::vector<int> first_seen_;  ///< of each image, that of the same place which came first
};

class GistPlaces final : public PlaceMethod {
 public:
  [[nodiscard]] std::string name() const override { return "Gist alone"; }
  void see(const cv::Mat1b& grey) override { gists_.push_back(finder_.find(grey)); }
  [[nodiscard]] PlaceGuess ask(int image, int before) override {
    PlaceGuess best;
    for (int k = 0; k < before; ++k) {
      const double score = -perception::gist_distance(gists_[static_cast<std::size_t>(image)],
                                                      gists_[static_cast<std::size_t>(k)]);
      if (best.image < 0 || score > best.score) best = {k, score};
    }
    return best;
  }

 private:
  perception::GistFinder finder_;
  std::vector<perception::Gist> gists_;
};

}  // namespace

std::unique_ptr<PlaceMethod> striate_places(int neighbours) {
  return std::make_unique<StriatePlaces>(neighbours);
}

std::unique_ptr<PlaceMethod> gist_places() {
  return std::make_unique<GistPlaces>();
}

std::vector<std::unique_ptr<PlaceMethod>> place_methods(int neighbours) {
  std::vector<std::unique_ptr<PlaceMethod>> methods;
  methods.push_back(striate_places(neighbours));
  methods.push_back(gist_places());
  methods.push_back(orb_word_places(WordsVerified::no));
  methods.push_back(orb_word_places(WordsVerified::yes));
  return methods;
}

}  // namespace striate::evaluation
