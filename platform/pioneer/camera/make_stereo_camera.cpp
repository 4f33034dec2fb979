#include "striate/platform/pioneer/camera/make_stereo_camera.hpp"

#include "striate/base/user_error.hpp"
#include "striate/platform/pioneer/camera/grabbing_camera.hpp"
#include "striate/platform/pioneer/camera/network_camera.hpp"
#include "striate/platform/pioneer/transport.hpp"

namespace striate::pioneer {

std::unique_ptr<StereoCamera> make_stereo_camera(const std::string& url,
                                                 const StereoCameraSettings& settings,
                                                 const Clock& clock) {
  const std::size_t colon = url.find(':');
  const std::string kind = url.substr(0, colon);
  const std::string rest = colon == std::string::npos ? std::string() : url.substr(colon + 1);
  if (kind == "tcp") return std::make_unique<NetworkCamera>(make_transport(url), settings, clock);
  if (kind == "video") {
    return std::make_unique<GrabbingCamera>(make_video_source(rest), settings, clock);
  }
  if (kind == "bumblebee") {
    return std::make_unique<GrabbingCamera>(make_bumblebee_source(rest), settings, clock);
  }
  throw UserError("'" + url +
                  "': is no camera\n"
                  "  hint: tcp://host:8104, video:/dev/video0, video:/dev/video0,/dev/video2, "
                  "video:FILE or bumblebee:");
}

}  // namespace striate::pioneer
