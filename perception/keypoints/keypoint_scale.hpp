#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "striate/perception/descriptor/descriptor_points.hpp"
#include "striate/perception/keypoints/end_stopped.hpp"
#include "striate/perception/keypoints/maxima.hpp"
#include "striate/perception/percept.hpp"
#include "striate/perception/v1/v1_cells.hpp"

namespace striate::perception {

/// A keypoint before it is chosen and described.
struct Candidate {
  double u_px = 0.0;  ///< in the image of its level
  double v_px = 0.0;
  double response = 0.0;  ///< comparable between scales
  int scale = 0;
};

/// One scale of keypoints: a wavelength in pixels of one level of the pyramid. Keeps its buffers.
class KeypointScale {
 public:
  /// @param index 0 for the finest; two per octave.
  KeypointScale(int index, double wavelength_px, const KeypointSettings& settings);

  /// Adds the maxima of K in the image of this level; more than the settings' `most` never.
  void find(const cv::Mat1b& image, std::vector<Candidate>& out);

  /// The descriptor of the nearest pixel, from the image found in last. What describes a
  /// keypoint is chosen here and nowhere else.
  [[nodiscard]] Descriptor describe(const Candidate& candidate) const;

 private:
  int index_;
  double wavelength_px_;
  KeypointSettings settings_;
  V1Cells v1_cells_;
  EndStoppedCells end_stopped_cells_;
  std::array<DescriptorPoint, kDescriptorPoints> points_;
  V1Responses responses_;
  Plane<std::uint16_t> response_;
  std::vector<GridPoint> maxima_;
};

}  // namespace striate::perception
