#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <optional>
#include <string>
#include <vector>

namespace striate::evaluation {

/// Where an image may have been taken.
struct PlaceGuess {
  int image = -1;      ///< the earlier one of the same place; -1: none
  double score = 0.0;  ///< the higher, the surer; comparable within a method
};

/// A way to know places again. All images are shown first, in their order; then it is asked.
class PlaceMethod {
 public:
  virtual ~PlaceMethod() = default;
  [[nodiscard]] virtual std::string name() const = 0;
  virtual void see(const cv::Mat1b& grey) = 0;
  /// Once, after the last image: what a method needs to have seen, such as its vocabulary.
  virtual void learn() {}
  /// The best of images 0 .. before - 1 for that one; asked in the order of the images.
  [[nodiscard]] virtual PlaceGuess ask(int image, int before) = 0;
  /// A guess is meant from here on; nothing: the method itself does not say.
  [[nodiscard]] virtual std::optional<double> threshold() const { return {}; }
};

/// @param neighbours images that follow each other so closely are of one place
[[nodiscard]] std::unique_ptr<PlaceMethod> striate_places(int neighbours);
/// The gist's nearest image, without confirmation.
[[nodiscard]] std::unique_ptr<PlaceMethod> gist_places();

/// Bags of words (Sivic and Zisserman 2003) of ORB keypoints: a vocabulary of k means in Hamming
/// space (k-majority) learned on all images of the run, which favours it; tf-idf, and the score of
/// Nister and Stewenius (2006).
enum class WordsVerified {
  no,
  /// The ten best are matched (Lowe's ratio) and a fundamental matrix is fitted by RANSAC; its
  /// inliers are the score. OpenCV's own, with customary settings.
  yes
};
[[nodiscard]] std::unique_ptr<PlaceMethod> orb_word_places(WordsVerified verified);

/// All of them, Striate's first.
[[nodiscard]] std::vector<std::unique_ptr<PlaceMethod>> place_methods(int neighbours);

}  // namespace striate::evaluation
