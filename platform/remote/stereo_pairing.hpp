#pragma once

#include <cstdint>
#include <deque>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "striate/base/time.hpp"

namespace striate::remote {

/// One eye's image with the sender's stamp.
struct EyeImage {
  std::int64_t stamp_ns = 0;
  cv::Mat3b image;
  int bits = 8;  ///< of which its 8 were made
};

struct ImagePair {
  EyeImage left;
  EyeImage right;
};

/// Puts images of two topics together whose stamps are nearest to each other, and near enough.
/// They may come in any order, late, or not at all; an image is used once, and what is older than
/// a pair that was found is thrown away.
class StereoPairing {
 public:
  explicit StereoPairing(Duration tolerance) : tolerance_(tolerance) {}

  /// The pair that this image completes.
  std::optional<ImagePair> add_left(EyeImage image) { return add(std::move(image), 0); }
  std::optional<ImagePair> add_right(EyeImage image) { return add(std::move(image), 1); }
  void clear();

 private:
  std::optional<ImagePair> add(EyeImage image, int eye);

  /// Images of one eye: 0.4 s at 20 Hz, longer than the other one may be late
  static constexpr std::size_t kWaiting = 8;
  Duration tolerance_;
  std::deque<EyeImage> waiting_[2];
};

}  // namespace striate::remote
