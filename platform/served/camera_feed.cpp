#include "striate/platform/served/camera_feed.hpp"

#include "striate/base/time.hpp"
#include "striate/platform/pioneer/camera/image_stream.hpp"

namespace striate::served {

CameraFeed::CameraFeed(simulator::ImageSource& pictures, Ready ready)
    : pictures_(pictures), ready_(std::move(ready)), thread_([this] { run(); }) {}

CameraFeed::~CameraFeed() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void CameraFeed::expose(Exposure exposure) {
  {
    const std::lock_guard lock(mutex_);
    if (busy_ || next_) return;
    next_ = std::move(exposure);
  }
  wake_.notify_one();
}

void CameraFeed::run() {
  while (true) {
    Exposure exposure;
    {
      std::unique_lock lock(mutex_);
      busy_ = false;
      wake_.wait(lock, [this] { return ends_ || next_; });
      if (ends_) return;
      exposure = std::move(*next_);
      next_.reset();
      busy_ = true;
    }
    try {
      StereoFrame frame = pictures_.image(exposure.scene);
      frame.stamp = TimePoint(from_seconds(exposure.scene.time_s));
      ready_(pioneer::image_stream::encode(frame, exposure.number), exposure.at);
    } catch (...) {  // a camera that misses an image; nothing may end the thread, and the program
    }
  }
}

}  // namespace striate::served
