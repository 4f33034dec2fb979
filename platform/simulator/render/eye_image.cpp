#include "striate/platform/simulator/render/eye_image.hpp"

namespace striate::simulator::render {
const std::vector<V4>& EyeImage::render(const View& view, bool smooth_edges) {
  const int pixels = view.width_px * view.height_px;
  light_.resize(at(pixels));
  group_.resize(at(pixels));
  mirror_width_ = (view.width_px + 1) / 2;
  mirror_height_ = (view.height_px + 1) / 2;
  mirror_.assign(at(mirror_width_ * mirror_height_), V4{});
  pending_count_ = 0;
  frame_people(view);
  trace_all(view);
  flush_mirror(view);
  if (smooth_edges) {
    const std::vector<int> pixels_at_edges = edges(view);
    for (std::size_t first = 0; first < pixels_at_edges.size(); first += 8) {
      resample(view, pixels_at_edges, first);
    }
  }
  blur_mirror();
  add_mirror(view);
  return light_;
}

void EyeImage::frame_people(const View& view) {
  frames_.clear();
  constexpr float kRadius_m = 0.75F;  // arms and legs in full stride
  for (const Occluder& person : people_.occluders()) {
    const Vec3 way = (person.foot + person.head) * 0.5F - view.origin;
    const float depth = dot(way, view.forward);
    if (depth < -2.0F) continue;
    Frame frame{-1.0F, 1e6F, -1.0F, 1e6F};
    if (depth > 2.0F) {
      const auto u = [&](float x) { return view.centre_u_px + view.focal_px * x; };
      const auto v = [&](float y) { return view.centre_v_px + view.focal_px * y; };
      const float near = 1.0F / (depth - kRadius_m);
      const float x = dot(way, view.right);
      const float y = dot(way, view.down);
      const float tall = 0.5F * length(person.head - person.foot) + 0.1F + kRadius_m;
      // Both depths count: what is off the axis moves outwards as it comes nearer.
      const float far = 1.0F / (depth + kRadius_m);
      frame = {u(std::min((x - kRadius_m) * near, (x - kRadius_m) * far)) - 4.0F,
               u(std::max((x + kRadius_m) * near, (x + kRadius_m) * far)) + 4.0F,
               v(std::min((y - tall) * near, (y - tall) * far)) - 4.0F,
               v(std::max((y + tall) * near, (y + tall) * far)) + 4.0F};
    }
    frames_.push_back(frame);
  }
}

bool EyeImage::people_in(int left, int top, int right, int bottom) const {
  for (const Frame& frame : frames_) {
    if (frame.left <= static_cast<float>(right) && frame.right >= static_cast<float>(left) &&
        frame.top <= static_cast<float>(bottom) && frame.bottom >= static_cast<float>(top)) {
      return true;
    }
  }
  return false;
}

void EyeImage::trace_all(const View& view) {
  for (int top = 0; top < view.height_px; top += 4) {
    for (int left = 0; left < view.width_px; left += 4) trace_tile(view, left, top);
  }
}

void EyeImage::trace_tile(const View& view, int left, int top) {
  Packet packet;
  packet.start(view.origin, kNear_m, kFar_m);
  aim_packet(view, left, top, packet.rays.ray.dir_x, packet.rays.ray.dir_y, packet.rays.ray.dir_z);
  const int columns = std::min(4, view.width_px - left);
  const int rows = std::min(4, view.height_px - top);
  for (int i = 0; (columns < 4 || rows < 4) && i < kPacket; ++i) {
    if (i % 4 >= columns || i / 4 >= rows) packet.valid[static_cast<std::size_t>(i)] = 0;
  }
  tracer_.intersect(packet, true, people_in(left, top, left + 3, top + 3));
  std::array<Shaded, Packet::kSize> shaded;
  shader_.shade(packet, 1.0F / view.focal_px, nullptr, shaded.data());
  std::array<bool, 4> mirrored{};
  for (unsigned i = 0; i < Packet::kSize; ++i) {
    if (packet.valid[i] == 0) continue;
    const int x = left + static_cast<int>(i % 4);
    const int y = top + static_cast<int>(i / 4);
    light_[at(y * view.width_px + x)] = shaded[i].colour;
    group_[at(y * view.width_px + x)] = shaded[i].group;
    const std::size_t block = (i / 8) * 2 + (i % 4) / 2;
    if (shaded[i].colour[3] > 0.004F && !mirrored[block]) {
      mirrored[block] = true;
      const Vec3 normal =
          unit({packet.rays.hit.Ng_x[i], packet.rays.hit.Ng_y[i], packet.rays.hit.Ng_z[i]});
      want_mirror(packet, i, normal, (y / 2) * mirror_width_ + x / 2);
      if (pending_count_ == Packet::kSize) flush_mirror(view);
    }
  }
}

}  // namespace striate::simulator::render
