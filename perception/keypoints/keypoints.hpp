#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "striate/perception/keypoints/keep_apart.hpp"
#include "striate/perception/keypoints/keypoint_scale.hpp"
#include "striate/perception/keypoints/keypoint_settings.hpp"
#include "striate/perception/percept.hpp"

namespace striate::perception {

/// End-stopped cells with tangential and radial inhibition (Rodrigues and du Buf 2006, 2009;
/// Terzic, Rodrigues and du Buf 2013): corners, junctions, line ends and blobs, at one scale or
/// many, on a pyramid of which each level serves two wavelengths. Each keypoint carries the
/// 256-bit descriptor of its nearest pixel. Keeps its buffers.
class KeypointFinder {
 public:
  /// Throws UserError for settings out of range.
  explicit KeypointFinder(const KeypointSettings& settings);

  /// @param grey any size; empty throws std::invalid_argument.
  /// @param out strongest first; of equally strong ones the finer, then the upper, then the left
  ///        one first. Its old content is lost, its memory used again: in the steady state
  ///        nothing is allocated here.
  void find(const cv::Mat1b& grey, std::vector<Keypoint>& out);
  [[nodiscard]] std::vector<Keypoint> find(const cv::Mat1b& grey);
  /// The same without descriptors, which stay zero: for those who describe in another way.
  void locate(const cv::Mat1b& grey, std::vector<Keypoint>& out);

 private:
  void build_pyramid(const cv::Mat1b& grey);
  void choose(cv::Size image);
  [[nodiscard]] double level_px(int scale) const;

  KeypointSettings settings_;
  std::vector<KeypointScale> scales_;
  std::vector<cv::Mat1b> pyramid_;  ///< level 0 is the given image; empty below the first used
  std::vector<Candidate> candidates_;
  KeepApart keep_apart_;
};

[[nodiscard]] std::vector<Keypoint> find_keypoints(const cv::Mat1b& grey,
                                                   const KeypointSettings& settings);

}  // namespace striate::perception
