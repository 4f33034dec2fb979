#pragma once

#include "striate/platform/pioneer/camera/image_stream.hpp"
#include "striate/platform/pioneer/camera/stereo_camera.hpp"
#include "striate/platform/pioneer/device_thread.hpp"

namespace striate::pioneer {

/// A camera that sends its images as a stream; see image_stream.hpp.
class NetworkCamera final : public StereoCamera {
 public:
  /// `clock` must outlive this.
  NetworkCamera(std::unique_ptr<Transport> line, const Clock& clock);
  [[nodiscard]] StereoFrame newest() const override { return device_.newest.newest(); }
  [[nodiscard]] std::string trouble() const override { return thread_.trouble(); }

 private:
  struct StreamDevice final : public Device {
    void line_up() override { reader.clear(); }
    void receive(ByteView bytes, TimePoint now) override;
    void tick(TimePoint /*now*/) override {}
    image_stream::Reader reader;
    Mailbox<StereoFrame> newest;
  };
  StreamDevice device_;
  DeviceThread thread_;  // last: it uses the device
};

}  // namespace striate::pioneer
