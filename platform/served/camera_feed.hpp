#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "striate/base/bytes.hpp"
#include "striate/base/time.hpp"
#include "striate/platform/simulator/image_source.hpp"

namespace striate::served {

/// Takes images of a served world in a thread of its own, so that light takes no time from the
/// wheels. A moment that comes while the last one is still being drawn is an image that is missed,
/// as with a camera that cannot keep up.
class CameraFeed {
 public:
  /// A moment to be seen.
  struct Exposure {
    simulator::SceneState scene;
    std::uint32_t number = 0;
    TimePoint at;  ///< by the machine's clock, SteadyClock::since_boot()
  };
  /// Gets a packet of the image stream, without its age; called in the feed's thread.
  using Ready = std::function<void(Bytes packet, TimePoint exposed_at)>;

  /// `images` must outlive this; nobody else may use it.
  CameraFeed(simulator::ImageSource& pictures, Ready ready);
  ~CameraFeed();
  CameraFeed(const CameraFeed&) = delete;
  CameraFeed& operator=(const CameraFeed&) = delete;

  void expose(Exposure exposure);

 private:
  void run();

  simulator::ImageSource& pictures_;
  Ready ready_;
  std::mutex mutex_;
  std::condition_variable wake_;
  std::optional<Exposure> next_;
  bool busy_ = false;
  bool ends_ = false;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace striate::served
