#include "striate/platform/pioneer/camera/network_camera.hpp"

namespace striate::pioneer {

NetworkCamera::NetworkCamera(std::unique_ptr<Transport> line, const Clock& clock)
    : thread_(device_, std::move(line), clock) {}

void NetworkCamera::StreamDevice::receive(ByteView bytes, TimePoint now) {
  reader.push(bytes);
  while (auto image = reader.next()) {
    image->frame.stamp = now - image->age;
    newest.put(std::move(image->frame));
  }
}

}  // namespace striate::pioneer
