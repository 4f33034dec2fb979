#include "striate/platform/pioneer/camera/network_camera.hpp"

namespace striate::pioneer {

NetworkCamera::NetworkCamera(std::unique_ptr<Transport> line, const StereoCameraSettings& expected,
                             const Clock& clock)
    : device_(expected), thread_(device_, std::move(line), clock) {}

}  // namespace striate::pioneer
