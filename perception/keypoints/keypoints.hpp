#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "perception/keypoints/end_stopped.hpp"
#include "perception/keypoints/keypoint_settings.hpp"
#include "perception/percept.hpp"
#include "perception/v1/v1_cells.hpp"

namespace striate {

/// End-stopped cells with tangential and radial inhibition (Rodrigues and du Buf 2006, 2009;
/// Terzic, Rodrigues and du Buf 2013): corners, junctions, line ends and blobs, one scale. Each
/// keypoint carries the 256-bit descriptor of its nearest pixel. Keeps its buffers.
class KeypointFinder {
 public:
  /// Throws UserError for settings out of range.
  explicit KeypointFinder(const KeypointSettings& settings);

  /// @param grey any size; empty throws std::invalid_argument.
  /// @return strongest first; of equally strong ones the upper, then the left one first.
  [[nodiscard]] std::vector<Keypoint> find(const cv::Mat1b& grey);

 private:
  void collect(std::vector<Keypoint>& found) const;
  void describe(std::vector<Keypoint>& found) const;

  KeypointSettings settings_;
  double scale_;  ///< of the picture that is worked on: 1 or 2 pixels of the given one
  double wavelength_px_;
  EndStoppedGeometry geometry_;
  V1Cells cells_;
  V1Responses responses_;
  ComplexPlanes complex_;
  Plane<float> response_;
};

[[nodiscard]] std::vector<Keypoint> find_keypoints(const cv::Mat1b& grey,
                                                   const KeypointSettings& settings);

}  // namespace striate
