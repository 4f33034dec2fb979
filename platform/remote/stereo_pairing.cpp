#include "striate/platform/remote/stereo_pairing.hpp"

#include <algorithm>
#include <cstdlib>

namespace striate::remote {

void StereoPairing::clear() {
  for (auto& eye : waiting_) eye.clear();
}

std::optional<ImagePair> StereoPairing::add(EyeImage image, int eye) {
  std::deque<EyeImage>& mine = waiting_[eye];
  std::deque<EyeImage>& others = waiting_[1 - eye];
  const auto distance_ns = [&](const EyeImage& other) {
    return std::abs(other.stamp_ns - image.stamp_ns);
  };
  const auto nearest = std::min_element(
      others.begin(), others.end(),
      [&](const auto& a, const auto& b) { return distance_ns(a) < distance_ns(b); });
  if (nearest == others.end() || distance_ns(*nearest) > tolerance_.count()) {
    mine.push_back(std::move(image));
    if (mine.size() > kWaiting) mine.pop_front();
    return std::nullopt;
  }
  ImagePair pair;
  pair.left = eye == 0 ? std::move(image) : std::move(*nearest);
  pair.right = eye == 0 ? std::move(*nearest) : std::move(image);
  others.erase(others.begin(), nearest + 1);
  const std::int64_t own_ns = eye == 0 ? pair.left.stamp_ns : pair.right.stamp_ns;
  while (!mine.empty() && mine.front().stamp_ns <= own_ns) mine.pop_front();
  return pair;
}

}  // namespace striate::remote
