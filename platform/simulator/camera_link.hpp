#pragma once

#include <cstdint>
#include <deque>

#include "platform/simulator/picture_source.hpp"
#include "platform/simulator/random.hpp"
#include "platform/simulator/simulator_settings.hpp"

namespace striate::simulator {

/// The way of the pictures from light to the program: when the shutter opens, how long a picture
/// is under way, and which never come.
class CameraLink {
 public:
  CameraLink(std::uint64_t seed, const SensorSettings& sensors, const FaultSettings& faults);

  /// Whether a picture is to be exposed in the step that ends now. Ask once a step.
  [[nodiscard]] bool due(double now_s);
  /// Counts all pictures, the lost ones too.
  [[nodiscard]] std::uint64_t frame() const { return frame_; }
  /// A picture has been taken; it is handed out when it has arrived.
  void take(StereoFrame picture, double now_s);
  /// Puts the newest picture that has arrived by now into `newest`; leaves it where none has.
  void deliver(double now_s, StereoFrame& newest);

 private:
  [[nodiscard]] bool lost(double now_s) const;

  struct UnderWay {
    double arrives_s = 0.0;
    StereoFrame picture;
  };
  Random random_;
  SensorSettings sensors_;
  FaultSettings faults_;
  std::deque<UnderWay> under_way_;
  std::uint64_t exposures_ = 0;
  std::uint64_t frame_ = 0;
};

}  // namespace striate::simulator
