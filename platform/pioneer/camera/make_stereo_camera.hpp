#pragma once

#include <memory>
#include <string>

#include "striate/base/time.hpp"
#include "striate/platform/pioneer/camera/stereo_camera.hpp"
#include "striate/platform/pioneer/camera/stereo_camera_settings.hpp"

namespace striate::pioneer {

/// @param url "tcp://host:8104" (an image stream), "video:..." or "bumblebee:..."
/// (frame_source.hpp). `clock` must outlive the camera.
/// @throws UserError for a url that is none, or for settings that do not go with it.
[[nodiscard]] std::unique_ptr<StereoCamera> make_stereo_camera(const std::string& url,
                                                               const StereoCameraSettings& settings,
                                                               const Clock& clock);

}  // namespace striate::pioneer
