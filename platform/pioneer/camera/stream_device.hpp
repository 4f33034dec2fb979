#pragma once

#include "striate/platform/pioneer/camera/image_stream.hpp"
#include "striate/platform/pioneer/camera/stereo_camera_settings.hpp"
#include "striate/platform/pioneer/device_thread.hpp"
#include "striate/platform/pioneer/line_clock.hpp"
#include "striate/platform/pioneer/questions.hpp"

namespace striate::pioneer {

/// The receiving end of an image stream: stamps images by when they were really exposed, however
/// long they were under way. It asks the sender four times a second; the connection itself counts
/// as the first answer, since nothing was sent before it. A sender that answers nothing is believed
/// in the distances between its stamps.
///
/// What cannot be, or is not an image of the camera that the settings describe (field of view and
/// baseline), is refused and said: the newest image is then the last good one, and grows old.
class StreamDevice final : public Device {
 public:
  explicit StreamDevice(const StereoCameraSettings& expected) : expected_(expected) {}
  void line_up(TimePoint now) override;
  void receive(ByteView bytes, TimePoint now) override;
  void tick(TimePoint now) override;
  [[nodiscard]] Bytes take_output() override { return std::exchange(output_, {}); }

  /// The newest image, from any thread.
  [[nodiscard]] StereoFrame newest() const { return newest_.newest(); }
  /// Why the image that came last was refused; "": it was not.
  [[nodiscard]] std::string refused() const { return refused_.newest(); }

 private:
  void take(image_stream::Image image, TimePoint now);

  StereoCameraSettings expected_;
  image_stream::Reader reader_;
  Questions<std::uint32_t> questions_;
  LineClock clock_;
  bool sender_tells_ = false;  ///< when it sends, so that `clock_` is its own
  std::uint32_t asked_ = 0;
  TimePoint asked_at_;
  TimePoint connected_at_;
  Bytes output_;
  Mailbox<StereoFrame> newest_;
  Mailbox<std::string> refused_;
};

}  // namespace striate::pioneer
