#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "striate/evaluation/places/place_methods.hpp"
#include "striate/evaluation/places/place_truth.hpp"
#include "striate/platform/datasets/sequences/sequence.hpp"

namespace striate::evaluation {

struct PlaceEvalOptions {
  int apart = 30;      ///< images: an earlier one that is nearer is no revisit
  int neighbours = 5;  ///< images that follow each other so closely are of one place
  PlaceTruthSettings truth;
};

/// Whether one image is of a place that was seen before, and what a method says.
struct PlaceQuestion {
  std::size_t image = 0;
  bool revisit = false;  ///< by the truth
  PlaceGuess guess;
  bool right = false;  ///< the guess is of the same place
};

/// What one method made of a sequence.
struct PlaceRun {
  std::string name;
  std::vector<PlaceQuestion> questions;
  std::optional<double> threshold;  ///< its own
  double ms = 0.0;                  ///< an image, of this thread: to see it and to be asked
};

/// At one threshold.
struct PlaceScore {
  double threshold = 0.0;
  int claimed = 0;  ///< guesses at or above it
  int right = 0;    ///< of them
  int revisits = 0;
  [[nodiscard]] double precision() const { return claimed > 0 ? 1.0 * right / claimed : 1.0; }
  [[nodiscard]] double recall() const { return revisits > 0 ? 1.0 * right / revisits : 0.0; }
};

/// At every threshold that makes a difference, the strictest first.
[[nodiscard]] std::vector<PlaceScore> sweep_places(std::span<const PlaceQuestion> questions);
/// The most that is found without a false one.
[[nodiscard]] PlaceScore without_false(std::span<const PlaceQuestion> questions);
/// At a threshold.
[[nodiscard]] PlaceScore at_threshold(std::span<const PlaceQuestion> questions, double threshold);

/// Shows each image of the sequence to every method and then asks them all in one run.
/// @param images is filled with what was shown
/// @param stopped asked before each image; empty: never
[[nodiscard]] std::vector<PlaceRun> run_place_methods(
    datasets::Sequence& sequence, const PlaceEvalOptions& options,
    const std::vector<std::unique_ptr<PlaceMethod>>& methods, std::vector<PlacedImage>& images,
    const std::function<bool()>& stopped);

/// Fills in what is a revisit and what is right; leaves out images that the truth does not tell of.
void judge_places(const PlaceTruth& truth, const PlaceEvalOptions& options,
                  std::vector<PlaceRun>& runs);

[[nodiscard]] std::string places_text(const std::vector<PlaceRun>& runs, bool judged);
[[nodiscard]] std::string places_json(const std::vector<PlaceRun>& runs,
                                      const std::vector<PlacedImage>& images, bool judged);
/// Into `out`: places.csv, places_guesses.csv and, where there is a truth, places_curves.csv and
/// places.svg.
void write_places(const std::vector<PlaceRun>& runs, const std::vector<PlacedImage>& images,
                  bool judged, const std::string& out);

}  // namespace striate::evaluation
