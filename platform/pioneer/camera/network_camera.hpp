#pragma once

#include "striate/platform/pioneer/camera/stereo_camera.hpp"
#include "striate/platform/pioneer/camera/stream_device.hpp"

namespace striate::pioneer {

/// A camera that sends its images as a stream; see image_stream.hpp.
class NetworkCamera final : public StereoCamera {
 public:
  /// `clock` must outlive this. @param expected what the stream's numbers are checked against
  NetworkCamera(std::unique_ptr<Transport> line, const StereoCameraSettings& expected,
                const Clock& clock);
  [[nodiscard]] StereoFrame newest() const override { return device_.newest(); }
  [[nodiscard]] std::string trouble() const override {
    const std::string line = thread_.trouble();
    return line.empty() ? device_.refused() : line;
  }

 private:
  StreamDevice device_;
  DeviceThread thread_;  // last: it uses the device
};

}  // namespace striate::pioneer
