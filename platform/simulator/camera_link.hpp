#pragma once

#include <cstdint>
#include <deque>

#include "striate/platform/simulator/image_source.hpp"
#include "striate/platform/simulator/random.hpp"
#include "striate/platform/simulator/simulator_settings.hpp"

namespace striate::simulator {

/// The way of the images from light to the program: when the shutter opens, how long an image
/// is under way, and which never come.
class CameraLink {
 public:
  CameraLink(std::uint64_t seed, const SensorSettings& sensors, const FaultSettings& faults);

  /// Whether an image is to be exposed in the step that ends now. Ask once a step.
  [[nodiscard]] bool due(double now_s);
  /// Counts all images, the lost ones too.
  [[nodiscard]] std::uint64_t frame() const { return frame_; }
  /// A image has been taken; it is handed out when it has arrived.
  void take(StereoFrame image, double now_s);
  /// Puts the newest image that has arrived by now into `newest`; leaves it where none has.
  void deliver(double now_s, StereoFrame& newest);

 private:
  [[nodiscard]] bool lost(double now_s) const;

  struct UnderWay {
    double arrives_s = 0.0;
    StereoFrame image;
  };
  Random random_;
  SensorSettings sensors_;
  FaultSettings faults_;
  std::deque<UnderWay> under_way_;
  std::uint64_t exposures_ = 0;
  std::uint64_t frame_ = 0;
};

}  // namespace striate::simulator
