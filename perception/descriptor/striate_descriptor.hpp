#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "perception/descriptor/striate_table.hpp"
#include "perception/percept.hpp"
#include "perception/v1/v1_cells.hpp"

namespace striate {

enum class StriateOrientation {
  given,     ///< the frame's angle
  upright,   ///< none: the picture's own
  dominant,  ///< of the odd V1 responses around the frame
};

struct StriateSettings {
  StriateOrientation orientation = StriateOrientation::given;
  StriateTable table = shipped_striate_table();
};

/// What is described.
struct DescribedFrame {
  double u_px = 0.0, v_px = 0.0;
  double size_px = 8.0;    ///< diameter, as OpenCV's keypoints have it: 2 sigma of a blob
  double angle_rad = 0.0;  ///< from +u towards +v
};

/// Responses of the odd simple cells, half-wave rectified and pooled at 25 points.
using PooledResponses = std::array<std::int32_t, kPooledValues>;

/// Striate's own 256-bit descriptor. Ours; only V1 responses enter. The surroundings of a frame
/// are resampled (turned and scaled, 2 px a diameter), odd simple cells of lambda = 3 px (1.5
/// diameters) respond, and Gaussians that grow with the distance pool them at 25 points on 4
/// circles. A bit compares two pooled responses; which ones and by how much was learned on made
/// pictures (`striate learn-descriptor`). Integer arithmetic after resampling. Match by Hamming
/// distance. Keeps its buffers.
class StriateDescriber {
 public:
  explicit StriateDescriber(const StriateSettings& settings);

  /// @param grey any size; empty throws std::invalid_argument.
  void prepare(const cv::Mat1b& grey);

  /// Of frames of the picture prepared; beyond the border the nearest pixel stands.
  /// @throws std::invalid_argument for a size that is not above 0 or a number that is not finite.
  void describe(std::span<const DescribedFrame> frames, std::vector<Descriptor>& out);

  /// Fills the keypoints' descriptors: size lambda, upright or dominant orientation.
  void describe(std::vector<Keypoint>& keypoints);

  /// What the bits are made of; for learning.
  void pool(std::span<const DescribedFrame> frames, std::vector<PooledResponses>& out);

 private:
  struct Weight {
    int pixel = 0;
    std::int32_t weight = 0;
  };
  void resample(std::span<const DescribedFrame> frames);
  [[nodiscard]] double dominant_angle_rad(int patch) const;
  void pool_patch(int patch, PooledResponses& out);

  StriateSettings settings_;
  V1Cells cells_;
  V1Responses responses_;
  std::array<std::vector<Weight>, kPooledPoints> weights_;
  std::vector<cv::Mat1b> halvings_;
  int levels_ = 0;
  cv::Mat1b patches_;
  std::vector<std::int32_t> rectified_;  ///< pixel by pixel, channels innermost
  std::vector<DescribedFrame> frames_, turned_;
  std::vector<PooledResponses> pooled_;
  std::vector<Descriptor> descriptors_;
};

}  // namespace striate
