#pragma once

#include <algorithm>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "striate/perception/v1/v1_cells.hpp"

namespace striate::perception {

/// Responses of odd simple cells to one part of an image at one of many sizes.
struct V1Field {
  const V1Responses* responses = nullptr;
  double zoom_u = 1.0, zoom_v = 1.0;  ///< pixels of the image a pixel of the field
  cv::Size whole;                     ///< the image at this size
  int left = 0, top = 0;              ///< of the field's first pixel in it

  /// Where a place of the image is in the field; one outside is moved to the nearest inside.
  [[nodiscard]] double u_of(double u_px) const {
    return std::clamp((u_px + 0.5) / zoom_u - 0.5, 0.0, whole.width - 1.0) - left;
  }
  [[nodiscard]] double v_of(double v_px) const {
    return std::clamp((v_px + 0.5) / zoom_v - 0.5, 0.0, whole.height - 1.0) - top;
  }
};

/// The odd simple cells of an image at sizes a quarter of an octave apart, each computed where it
/// is asked for and only around the places that are looked at. Beyond the image its nearest pixel
/// stands. Keeps its buffers.
class V1Scales {
 public:
  static constexpr int kPerOctave = 4;  ///< sizes are off by at most an eighth of an octave, 9 %

  /// @param reach_px how far around a place responses are read, in pixels of the field.
  V1Scales(const V1Settings& settings, int reach_px) : cells_(settings), reach_px_(reach_px) {}

  /// @param grey any size; empty throws std::invalid_argument.
  void prepare(const cv::Mat1b& grey);

  /// The size at which a pixel is about so many pixels of the image: 2^(level / kPerOctave).
  [[nodiscard]] int level_of(double step_px) const;

  /// @param box places of the image, inclusive, that will be looked at.
  /// @throws std::invalid_argument where no image was prepared.
  /// @return valid until the next call. The responses there do not depend on the box.
  V1Field respond(int level, const cv::Rect2d& box);

 private:
  V1Cells cells_;
  int reach_px_;
  std::vector<cv::Mat1b> halvings_;
  int halved_ = 0;  ///< halvings in use
  cv::Mat1b resized_, padded_;
  V1Responses responses_;
};

}  // namespace striate::perception
