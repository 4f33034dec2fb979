#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace striate::simulator::render {

/// Colours between the cells of a Bayer mosaic, and the tone curve: Malvar, He and Cutler 2004,
/// "High-quality linear interpolation for demosaicing of Bayer-patterned color images": bilinear
/// plus the gradient of the colour that is known. Held between the neighbours of its own colour, as
/// cameras do: else every lamp has a fringe.
class Demosaic {
 public:
  static constexpr int kMargin = 2;  ///< cells readable round the image
  static constexpr int kSlack = 4;   ///< cells readable behind the last one

  Demosaic(int width, int height);

  /// @param raw levels 0..1 of full scale, rows of width + 2 kMargin cells, kMargin rows above and
  /// below; red and green on even rows, green and blue on odd ones.
  [[nodiscard]] cv::Mat3b image(const std::vector<float>& raw);

 private:
  /// Interpolations at every cell of a row, whether or not its colour wants them, as places in the
  /// tone curve: so it goes four at a time, without branches.
  struct Row {
    std::vector<int> here, beside, above, green, other;
  };
  void interpolate(const float* cell);

  int width_;
  int height_;
  Row row_;
  std::vector<std::uint8_t> tone_;
};

}  // namespace striate::simulator::render
