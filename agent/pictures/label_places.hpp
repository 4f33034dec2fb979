#pragma once

#include <opencv2/core.hpp>

namespace striate::agent::pictures {

/// Where labels go in a picture, so that they lie on nothing that is to be seen and not on each
/// other.
class LabelPlaces {
 public:
  explicit LabelPlaces(cv::Size size) : taken_(size, static_cast<uchar>(0)) {}

  /// What labels are to keep off: the caller draws it here, in any value but 0.
  [[nodiscard]] cv::Mat1b& taken() { return taken_; }

  /// The place for a label near an anchor, within the picture; it is taken from then on. The
  /// nearest one that covers nothing, else the one that covers least.
  [[nodiscard]] cv::Rect take(cv::Point anchor, cv::Size label);

 private:
  cv::Mat1b taken_;
};

}  // namespace striate::agent::pictures
