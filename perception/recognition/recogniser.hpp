#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <opencv2/core/types.hpp>
#include <span>
#include <vector>

#include "striate/perception/matching/descriptor_store.hpp"
#include "striate/perception/matching/hamming_search.hpp"
#include "striate/perception/recognition/claims.hpp"
#include "striate/perception/recognition/consensus.hpp"
#include "striate/perception/recognition/evidence.hpp"
#include "striate/perception/recognition/landmark_view.hpp"
#include "striate/perception/recognition/recognition_settings.hpp"
#include "striate/perception/recognition/shared_parts.hpp"

namespace striate::perception {

/// How much looking may cost. The views that come first in the order are looked at first.
struct RecognitionBudget {
  std::size_t most_views = std::numeric_limits<std::size_t>::max();
  /// Asked before each view but the first; false ends the search. Empty: nothing ends it. Who
  /// wants a limit of time asks a clock here.
  std::function<bool()> goes_on;
};

/// Where a landmark is expected in the image; what was known before takes less to be believed.
struct ExpectedPlace {
  int landmark = 0;
  cv::Rect2d box;  ///< that its middle lies in, in px of the image
};

/// Finds landmarks that were taught in the keypoints of an image or of a salient region. Holds the
/// views as searching wants them; who remembers landmarks adds and removes them. Nothing is
/// allocated once the buffers have grown to what the images need.
class Recogniser {
 public:
  /// @throws UserError for settings out of range.
  explicit Recogniser(const RecognitionSettings& settings);

  /// @param landmark a number of the caller's; views of one landmark share it.
  /// @return the view's number, from 0 upwards; that of a removed view is given again.
  /// @throws std::invalid_argument where keypoints and descriptors differ in number, or a size is
  /// not above 0.
  int add(int landmark, const LandmarkView& view);
  /// @throws std::out_of_range where there is no such view.
  void remove(int view);
  [[nodiscard]] std::size_t size() const { return in_use_; }  ///< views

  /// Looks for all views, in the order of their numbers.
  /// @return an entry for each landmark that is there, its best view; most inliers first, of equals
  /// the one with the lower number. Valid until the next call.
  const std::vector<Recognition>& recognise(std::span<const Keypoint> keypoints);

  /// Looks for the views of `order` (numbers as add() gave them, the most active first) until the
  /// budget is spent. Numbers of removed views are passed over.
  /// @param expected where memory expects some of them; `least_share_expected` counts there.
  const std::vector<Recognition>& recognise(std::span<const Keypoint> keypoints,
                                            std::span<const int> order,
                                            const RecognitionBudget& budget,
                                            std::span<const ExpectedPlace> expected = {});
  /// How many views the last call looked at.
  [[nodiscard]] std::size_t looked_at() const { return looked_at_; }

 private:
  struct View {
    bool in_use = false;
    int landmark = 0;
    DescriptorStore store;
    std::vector<KeypointFrame> places;  ///< of each descriptor
    double width_px = 0.0;
    double height_px = 0.0;
    SharedParts shared;        ///< found out when the view is recognised for the first time ...
    std::size_t compared = 0;  ///< ... by comparing it with so many of the others ...
    std::uint64_t change = 0;  ///< ... as they were after this change
  };

  void begin(std::span<const Keypoint> keypoints);
  void look_for(int number, std::span<const Keypoint> keypoints);
  [[nodiscard]] bool find_by_papers_rule(const View& view, std::span<const Keypoint> keypoints,
                                         Recognition& found);
  [[nodiscard]] bool find_pose(View& view, Recognition& found);
  void find_pairs(const View& view, std::span<const Descriptor> descriptors,
                  std::span<const KeypointFrame> places);
  [[nodiscard]] bool find_shared_parts(View& view);
  [[nodiscard]] int keep_what_is_its_own(View& view);
  [[nodiscard]] bool agrees_all_over(const View& view, const Consensus& consensus, double own,
                                     double least_share);
  [[nodiscard]] bool is_expected(const Recognition& found) const;
  void add_pair(const View& view, const KeypointFrame& place, std::span<const Match> matches);
  void keep(const Recognition& recognition);
  /// What speaks for a view beyond chance.
  struct Found {
    PairsUnderPose all;
    Pose pose;
    double side_px = 1.0;  ///< of the view
    int carried = 0;       ///< pairs that carry the pose and tell nothing else
  };
  [[nodiscard]] double evidence(std::span<const PlacePair> agreeing, const Found& of);
  [[nodiscard]] static bool is_enough(double score) { return score >= 0.5; }
  void leave_each_keypoint_to_one();
  const std::vector<Recognition>& sorted();

  RecognitionSettings settings_;
  std::vector<View> views_;
  std::uint64_t change_ = 0;  ///< counts views that were added or removed
  std::size_t in_use_ = 0, looked_at_ = 0;
  double finest_px_ = 0.0;  ///< least size of the image's keypoints
  HammingSearch search_;
  ConsensusFinder consensus_;
  std::vector<Descriptor> queries_;
  std::vector<KeypointFrame> query_places_;
  std::vector<PlacePair> pairs_;
  std::vector<PlacePair> agreeing_;        ///< of them, those that count
  std::vector<PlacePair> pairs_of_image_;  ///< kept while a view is compared with others
  std::vector<Descriptor> descriptors_;    ///< of that view
  std::vector<Match> nearest_;             ///< paper: of every descriptor of a view
  std::vector<KeypointFrame> visible_;     ///< of a view, at the scale it was found at
  Found compared_;                         ///< of the view that was compared last
  std::vector<double> residuals_;
  std::span<const ExpectedPlace> expected_;  ///< during a call of recognise()
  std::vector<Recognition> found_;
  std::vector<Found> why_;  ///< of each of found_
  Claims claims_;           ///< of each of found_
  std::vector<std::size_t> order_;
  std::vector<int> points_;
};

}  // namespace striate::perception
