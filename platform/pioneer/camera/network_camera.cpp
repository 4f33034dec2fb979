#include "platform/pioneer/camera/network_camera.hpp"

namespace striate::pioneer {

NetworkCamera::NetworkCamera(std::unique_ptr<Transport> line, const Clock& clock)
    : thread_(device_, std::move(line), clock) {}

void NetworkCamera::StreamDevice::receive(ByteView bytes, TimePoint now) {
  reader.push(bytes);
  while (auto picture = reader.next()) {
    picture->frame.stamp = now - picture->age;
    newest.put(std::move(picture->frame));
  }
}

}  // namespace striate::pioneer
