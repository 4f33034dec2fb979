#pragma once

#include <cstdint>
#include <deque>
#include <opencv2/core/mat.hpp>
#include <optional>

#include "platform/interface/time.hpp"

namespace striate::ros1 {

/// One eye's picture with the sender's stamp.
struct EyePicture {
  std::int64_t stamp_ns = 0;
  cv::Mat3b picture;
};

struct PicturePair {
  EyePicture left;
  EyePicture right;
};

/// Puts pictures of two topics together whose stamps are nearest to each other, and near enough.
/// They may come in any order, late, or not at all; a picture is used once, and what is older than
/// a pair that was found is thrown away.
class StereoPairing {
 public:
  explicit StereoPairing(Duration tolerance) : tolerance_(tolerance) {}

  /// The pair that this picture completes.
  std::optional<PicturePair> add_left(EyePicture picture) { return add(std::move(picture), 0); }
  std::optional<PicturePair> add_right(EyePicture picture) { return add(std::move(picture), 1); }
  void clear();

 private:
  std::optional<PicturePair> add(EyePicture picture, int eye);

  /// Pictures of one eye: 0.4 s at 20 Hz, longer than the other one may be late
  static constexpr std::size_t kWaiting = 8;
  Duration tolerance_;
  std::deque<EyePicture> waiting_[2];
};

}  // namespace striate::ros1
