#pragma once

#include <span>
#include <vector>

#include "perception/matching/descriptor_store.hpp"
#include "perception/matching/hamming_search.hpp"
#include "perception/recognition/consensus.hpp"
#include "perception/recognition/object_model.hpp"
#include "perception/recognition/recognition_settings.hpp"

namespace striate {

/// Finds taught objects in the keypoints of a picture or of a salient region. Nothing is allocated
/// once the buffers have grown to what the pictures need.
class Recogniser {
 public:
  /// The models are only read here: their descriptors and places are copied.
  /// @throws UserError for settings out of range.
  Recogniser(std::span<const ObjectModel> models, const RecognitionSettings& settings);

  /// @return an entry for each object that is there, its best view; most inliers first, of equals
  /// the one that was taught first. Valid until the next call.
  const std::vector<Recognition>& recognise(std::span<const Keypoint> keypoints);

 private:
  struct View {
    int object;
    int number;         ///< of the object's views
    std::size_t first;  ///< its descriptors in the store
    std::size_t count;
    double width_px;
    double height_px;
  };
  struct Candidate {
    std::size_t view;
    PlacePair pair;
  };

  void recognise_as_in_paper(std::span<const Keypoint> keypoints);
  void choose_candidates(std::span<const Keypoint> keypoints, std::span<const Match> matches);
  void add_candidate(const Keypoint& keypoint, std::span<const Match> of_view);
  void sort_by_view();
  void keep(const Recognition& recognition);

  RecognitionSettings settings_;
  std::vector<View> views_;
  std::vector<std::size_t> view_of_;  ///< of every stored descriptor
  std::vector<Place> places_;         ///< of every stored descriptor, in its view
  DescriptorStore store_;
  HammingSearch search_;
  ConsensusFinder consensus_;
  std::vector<Descriptor> queries_;
  std::vector<Candidate> candidates_;
  std::vector<std::size_t> starts_;  ///< of each view's pairs
  std::vector<PlacePair> pairs_;
  std::vector<Match> nearest_;  ///< paper: of every stored descriptor
  std::vector<Recognition> found_;
};

}  // namespace striate
