#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "striate/base/index_within.hpp"

/// Small drawing helpers that all pictures share. Colours are BGR.
namespace striate::agent::pictures {

inline const cv::Scalar kBackground{30, 27, 25};   ///< nearly black, so that pictures stand out
inline const cv::Scalar kInk{235, 235, 235};       ///< light grey on the dark ground: text
inline const cv::Scalar kQuietInk{165, 160, 155};  ///< darker grey: text that may be overlooked
inline const cv::Scalar kHidden{16, 14, 13};       ///< darker than the unknown (ours)
inline const cv::Scalar kFree{110, 200, 90};       ///< green: floor that is seen free
inline const cv::Scalar kBlocked{60, 60, 235};     ///< red: what stands there (ours)
inline const cv::Scalar kCorridor{235, 190, 60};   ///< blue: walls and axis of the corridor

/// By hand: as far outside of the image, px, may a drawing begin; OpenCV counts with fractions of
/// it
inline constexpr int kFarthestDrawn = 1 << 20;

/// The nearest pixel; of places far outside, one that is still outside.
[[nodiscard]] inline int drawn_px(double px) {
  return round_within(px, -kFarthestDrawn, kFarthestDrawn);
}

/// Text with its baseline's left end at `at`, anti-aliased; `size` 1 is 11 px high capitals.
void write(cv::Mat3b& image, const std::string& text, cv::Point at, const cv::Scalar& colour,
           double size = 1.0);

/// The same on a dark plate, kept inside the image; `at` is the plate's top left corner.
void write_label(cv::Mat3b& image, const std::string& text, cv::Point at, const cv::Scalar& colour);

/// Width of `text` in pixels.
[[nodiscard]] int text_width(const std::string& text, double size = 1.0);

/// `image` at `size`: smooth when it grows, averaged when it shrinks; grey becomes BGR.
[[nodiscard]] cv::Mat3b fit(const cv::Mat3b& image, cv::Size size);

/// Lays `colour` over the pixels where `mask` is set, with this opacity.
void tint(cv::Mat3b& image, const cv::Mat1b& mask, const cv::Scalar& colour, double opacity);

}  // namespace striate::agent::pictures
