#pragma once

#include "striate/platform/pioneer/camera/image_stream.hpp"
#include "striate/platform/pioneer/device_thread.hpp"
#include "striate/platform/pioneer/line_clock.hpp"
#include "striate/platform/pioneer/questions.hpp"

namespace striate::pioneer {

/// The receiving end of an image stream: stamps images by when they were really exposed, however
/// long they were under way. It asks the sender four times a second; the connection itself counts
/// as the first answer, since nothing was sent before it. A sender that answers nothing is believed
/// in the distances between its stamps.
class StreamDevice final : public Device {
 public:
  void line_up(TimePoint now) override;
  void receive(ByteView bytes, TimePoint now) override;
  void tick(TimePoint now) override;
  [[nodiscard]] Bytes take_output() override { return std::exchange(output_, {}); }

  /// The newest image, from any thread.
  [[nodiscard]] StereoFrame newest() const { return newest_.newest(); }

 private:
  void take(image_stream::Image image, TimePoint now);

  image_stream::Reader reader_;
  Questions<std::uint32_t> questions_;
  LineClock clock_;
  bool sender_tells_ = false;  ///< when it sends, so that `clock_` is its own
  std::uint32_t asked_ = 0;
  TimePoint asked_at_;
  TimePoint connected_at_;
  Bytes output_;
  Mailbox<StereoFrame> newest_;
};

}  // namespace striate::pioneer
