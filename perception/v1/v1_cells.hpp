#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "striate/perception/v1/filter_bank.hpp"
#include "striate/perception/v1/plane.hpp"
#include "striate/perception/v1/v1_kernels.hpp"
#include "striate/perception/v1/v1_settings.hpp"

namespace striate::perception {

/// Responses of V1 at every pixel of one image. All planes have the image's size.
struct V1Responses {
  int width = 0;
  int height = 0;
  double wavelength_px = 0.0;
  double gain = 1.0;  ///< even and odd are `gain` times the model's response to grey 0..255

  /// Complex cells, C_i^2 = even_i^2 + odd_i^2, as a 16-bit code that grows with C_i: the leading
  /// bits of the float C_i^2 + 1; see complex_response(). Beyond the image, `margin()` pixels
  /// on each side, the nearest pixel's value stands.
  std::array<Plane<std::int16_t>, kOrientations> code;

  /// Simple cells; filled only when asked for.
  std::array<Plane<std::int16_t>, kOrientations> even;
  std::array<Plane<std::int16_t>, kOrientations> odd;

  [[nodiscard]] int margin() const { return code[0].margin_rows(); }
};

/// C in units of the simple cells' 16-bit responses, from its code.
[[nodiscard]] float complex_response(std::int16_t code);

enum class SimpleCells { even_and_odd, odd };

/// Simple and complex cells of 8 orientations (the paper's section on V1, equation 1; the model
/// of Rodrigues and du Buf 2006). Outside the image it is mirrored without repeating the border
/// pixel. Keeps its buffers: after the first image of a size nothing is allocated.
class V1Cells {
 public:
  explicit V1Cells(const V1Settings& settings);

  /// @param grey any size from 1x1: 8 bits, or 16 bits that count sixteenths of a grey level (0 to
  /// 4095; what averaging many pixels leaves behind the point tells on blank surfaces); anything
  /// else throws std::invalid_argument. Both give the same bits for the same greys.
  /// @param margin pixels that the codes are continued beyond the border.
  /// @param simple_cells also fill `even` and `odd`.
  void respond(const cv::Mat& grey, int margin, bool simple_cells, V1Responses& out);

  /// The simple cells only, or of them only the odd ones, which takes less time. The same bits as
  /// respond() gives; what is not asked for in `out` is left as it is.
  void respond_simple(const cv::Mat& grey, SimpleCells which, V1Responses& out);

  [[nodiscard]] const FilterBank& bank() const { return bank_; }

 private:
  struct PackedProduct {
    v1_kernels::RowTaps row;
    std::array<std::vector<std::int32_t>, 2> even, odd;  ///< for output rows of even and odd y
    std::size_t slot = 0;
    int index = 0;          ///< counted over all pairs
    bool feeds_odd = true;  ///< has odd taps that are not zero
  };
  struct Wanted {
    bool complex = true, even = true, odd = true;
  };
  void take_image(const cv::Mat& grey);
  void respond(const cv::Mat& grey, V1Responses& out);
  [[nodiscard]] bool is_needed(const PackedProduct& p) const;
  void sum_boxes(int height);
  void filter_row_pair(int j);
  void respond_rows(int y, V1Responses& out);

  V1Settings settings_;
  FilterBank bank_;
  std::vector<std::vector<PackedProduct>> packed_;  ///< one list per pair of the bank
  int products_ = 0;                                ///< in all lists
  Plane<std::int16_t> image_;  ///< 16 (grey - 128), mirrored beyond its left and right border
  std::vector<int> beyond_left_, beyond_right_;  ///< columns that are mirrored there
  std::array<Plane<std::int32_t>, 2> folded_;    ///< two rows; see v1_kernels::FoldedRow
  /// Filtered pairs of rows: those that the current output rows need, in turn; per product.
  Plane<std::int32_t> row_sums_;
  Plane<std::int32_t> box_rows_;
  Plane<std::int32_t> box_;
  v1_kernels::ColumnJob job_;
  Wanted wanted_;
};

}  // namespace striate::perception
