#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <span>
#include <vector>

#include "striate/perception/descriptor/dominant_angle.hpp"
#include "striate/perception/descriptor/pooling_kernels.hpp"
#include "striate/perception/descriptor/striate_table.hpp"
#include "striate/perception/descriptor/v1_scales.hpp"
#include "striate/perception/percept.hpp"

namespace striate::perception {

enum class StriateOrientation {
  given,     ///< the frame's angle
  upright,   ///< none: the image's own
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

/// A frame's surroundings in V1.
struct DescribedPlace {
  pooling_kernels::OddWindow window;
  double u = 0.0, v = 0.0;   ///< pixels from the window's first
  std::int16_t largest = 0;  ///< of the window's responses
};

/// Striate's own 256-bit descriptor. Ours; only V1 responses enter. The image is taken at the
/// size at which a frame's diameter is about 2 px (sizes are a quarter of an octave apart), where
/// odd simple cells of lambda = 3 px (1.5 diameters) respond once for all frames of that size. What
/// they would say of the turned image lies between the responses of neighbouring orientations;
/// Gaussians that grow with the distance pool it at 25 points on 4 circles. A bit compares two
/// pooled responses; which ones and by how much was learned on made images
/// (`striate learn-descriptor`). Integer arithmetic: the same bits on every instruction set. Match
/// by Hamming distance. Keeps its buffers.
class StriateDescriber {
 public:
  explicit StriateDescriber(const StriateSettings& settings);

  /// @param grey any size; empty throws std::invalid_argument.
  void prepare(const cv::Mat1b& grey);

  /// Of frames of the image prepared; a place outside counts as the nearest one inside.
  /// @throws std::invalid_argument for a size that is not above 0 or a number that is not finite.
  void describe(std::span<const DescribedFrame> frames, std::vector<Descriptor>& out);

  /// Each frame with the direction in which it grows brighter (dominant_angle.hpp) instead of its
  /// angle. One with two such directions stands twice where `second` says so.
  /// @param turned the frames as they were described, in the given order.
  void describe_oriented(std::span<const DescribedFrame> frames, bool second,
                         std::vector<DescribedFrame>& turned, std::vector<Descriptor>& out);

  /// What the bits are made of; for learning.
  void pool(std::span<const DescribedFrame> frames, std::vector<PooledResponses>& out);

 private:
  /// One row of a Gaussian's taps.
  struct Taps {
    int first_px = 0;  ///< where they begin, from the pixel left of the middle
    std::vector<std::int16_t> taps;
  };
  struct Circle {
    std::vector<cv::Point2d> points;  ///< px from the middle, of an upright frame
    std::vector<Taps> rows;           ///< by sixteenths of a pixel
  };
  template <class See>
  void visit(std::span<const DescribedFrame> frames, See see);
  void pool_place(const DescribedPlace& place, double angle_rad, PooledResponses& out);

  StriateSettings settings_;
  V1Scales scales_;
  std::vector<Circle> circles_;
  std::vector<std::int16_t> turned_window_;
  std::vector<int> levels_;  ///< of the frames
  std::vector<DescribedFrame> turned_;
  std::vector<DominantAngles> angles_;
  std::vector<std::array<Descriptor, 2>> pairs_;
  PooledResponses one_{};
};

}  // namespace striate::perception
