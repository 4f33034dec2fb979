#pragma once

#include <span>
#include <vector>

#include "striate/perception/recognition/pose.hpp"
#include "striate/perception/recognition/recognition_settings.hpp"

namespace striate::perception {

/// The pose that most pairs agree with.
struct Consensus {
  int inliers = 0;  ///< different keypoints of the view that agree; 0: no pose
  Pose pose;        ///< view to image
};

/// The pixel of the image that a pair is at, as one number.
[[nodiscard]] int image_place(const PlacePair& pair);

/// How many different keypoints a set of pairs has: of the view or of the image, whichever are
/// fewer. Several keypoints of the image may agree with one of the view: it counts once. So does a
/// place of the image that several keypoints of the view claim.
/// @param points a buffer
[[nodiscard]] int different_keypoints(std::span<const PlacePair> pairs, std::vector<int>& points);

/// Whether two poses differ by less than a factor of two in size and less than 36 degrees in turn.
[[nodiscard]] bool turned_alike(const Pose& a, const Pose& b);

/// Finds the pose of a view by voting: every pair proposes the similarity that its two keypoints
/// say (place, size, orientation); the proposal that most others support is refined by least
/// squares, first as a similarity, then as an affine map. No random numbers: all are tried. Keeps
/// its buffers.
class ConsensusFinder {
 public:
  explicit ConsensusFinder(const RecognitionSettings& settings) : settings_(settings) {}

  /// @param width_px, height_px of the view; tolerances are shares of its mean side.
  [[nodiscard]] Consensus find(std::span<const PlacePair> pairs, double width_px, double height_px);
  /// The pairs that agree with what find() found; valid until it is called again.
  [[nodiscard]] std::span<const PlacePair> agreeing() const { return agreeing_; }

 private:
  std::size_t propose(std::span<const PlacePair> pairs, double tolerance_px);
  void gather(std::span<const PlacePair> pairs, const Pose& pose, double tolerance_px);
  [[nodiscard]] bool plausible(const Pose& pose) const;

  RecognitionSettings settings_;
  std::vector<Pose> poses_;  ///< that each pair says by itself
  std::vector<PlacePair> agreeing_;
  std::vector<int> points_;
};

}  // namespace striate::perception
