#pragma once

#include <memory>
#include <string>

#include "platform/interface/senses.hpp"
#include "platform/pioneer/camera/stereo_camera_settings.hpp"

namespace striate::pioneer {

/// Two eyes that look by themselves, in a thread of their own; the newest rectified pair waits in
/// one slot.
class StereoCamera {
 public:
  virtual ~StereoCamera() = default;
  /// The newest pair, stamped with the middle of its exposure; empty until the first has come. The
  /// pixels are shared and do not change. `head` is left for the caller.
  [[nodiscard]] virtual StereoFrame newest() const = 0;
  /// Why no picture comes, in plain words; empty: nothing is known to be wrong.
  [[nodiscard]] virtual std::string trouble() const = 0;
};

/// @param url "tcp://host:8104" (a picture stream), "video:..." or "bumblebee:..."
/// (frame_source.hpp). `clock` must outlive the camera.
/// @throws UserError for a url that is none, or for settings that do not go with it.
[[nodiscard]] std::unique_ptr<StereoCamera> make_stereo_camera(const std::string& url,
                                                               const StereoCameraSettings& settings,
                                                               const Clock& clock);

}  // namespace striate::pioneer
