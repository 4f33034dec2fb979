#pragma once

#include <functional>

#include "striate/platform/simulator/render/tracer.hpp"

namespace striate::simulator::render {

/// Sends shadow rays sixteen at a time and hands over those that arrive.
class ShadowRays {
 public:
  using Arrived = std::function<void(int texel, V4 light)>;
  ShadowRays(const Tracer& tracer, Arrived arrived)
      : tracer_(tracer), arrived_(std::move(arrived)) {}
  void add(Vec3 from, Vec3 way, float t_max, int texel, V4 light) {
    packet_.set(count_, from, way, 1e-4F, t_max);
    texel_[count_] = texel;
    light_[count_] = light;
    if (++count_ == Packet::kSize) flush();
  }
  void flush() {
    for (unsigned i = count_; i < Packet::kSize; ++i) packet_.clear(i);
    if (count_ > 0) tracer_.occlude(packet_);
    for (unsigned i = 0; i < count_; ++i) {
      if (packet_.rays.ray.tfar[i] > 0.0F) arrived_(texel_[i], light_[i]);
    }
    count_ = 0;
  }

 private:
  const Tracer& tracer_;
  Arrived arrived_;
  Packet packet_;
  std::array<int, Packet::kSize> texel_{};
  std::array<V4, Packet::kSize> light_{};
  unsigned count_ = 0;
};

}  // namespace striate::simulator::render
