#include "striate/platform/simulator/render/eye_image.hpp"

namespace striate::simulator::render {
void EyeImage::want_mirror(const Packet& packet, unsigned lane, Vec3 normal, int cell) {
  const Vec3 d = packet.direction(lane);
  const Vec3 n = dot(normal, d) < 0.0F ? normal : normal * -1.0F;
  const Vec3 reflected = unit(d - n * (2.0F * dot(d, n)));
  pending_before_m_[pending_count_] = length(d) * packet.rays.ray.tfar[lane];
  pending_cell_[pending_count_] = cell;
  pending_.set(pending_count_++, packet.place(lane) + n * 0.002F, reflected, 0.001F, kFar_m);
}

void EyeImage::flush_mirror(const View& view) {
  if (pending_count_ == 0) return;
  for (unsigned i = pending_count_; i < Packet::kSize; ++i) pending_.clear(i);
  tracer_.intersect(pending_, true);
  std::array<Shaded, Packet::kSize> shaded;
  shader_.shade(pending_, 2.5F / view.focal_px, pending_before_m_.data(), shaded.data());
  for (unsigned i = 0; i < pending_count_; ++i) {
    V4 colour = shaded[i].colour;
    colour[3] = 1.0F;
    mirror_[at(pending_cell_[i])] = colour;
  }
  pending_count_ = 0;
}

/// A worn floor smears its mirror image, most along the line of sight.
void EyeImage::blur_mirror() {
  scratch_.assign(mirror_.size(), V4{});
  const auto pass = [&](const std::vector<V4>& from, std::vector<V4>& to, int dx, int dy,
                        int reach) {
    for (int y = 0; y < mirror_height_; ++y) {
      for (int x = 0; x < mirror_width_; ++x) {
        const int here = y * mirror_width_ + x;
        if (from[at(here)][3] <= 0.0F) continue;
        V4 sum{};
        for (int k = -reach; k <= reach; ++k) {
          const int px = x + k * dx;
          const int py = y + k * dy;
          if (px < 0 || py < 0 || px >= mirror_width_ || py >= mirror_height_) continue;
          sum += from[at(py * mirror_width_ + px)] *
                 splat(static_cast<float>(reach + 1 - std::abs(k)));
        }
        to[at(here)] = sum * splat(1.0F / sum[3]);
      }
    }
  };
  pass(mirror_, scratch_, 0, 1, 2);
  std::swap(mirror_, scratch_);
  pass(mirror_, scratch_, 1, 0, 1);
  std::swap(mirror_, scratch_);
}

void EyeImage::add_mirror(const View& view) {
  for (int y = 0; y < view.height_px; ++y) {
    // Cell c covers pixels 2c and 2c + 1: pixel y lies a quarter cell beside its middle.
    const int y0 = std::max(0, (y - 1) / 2);
    const int y1 = std::min(mirror_height_ - 1, (y + 1) / 2);
    const float wy = y % 2 == 0 ? 0.75F : 0.25F;
    for (int x = 0; x < view.width_px; ++x) {
      V4& pixel = light_[at(y * view.width_px + x)];
      const float weight = pixel[3];
      if (weight <= 0.0F) continue;
      const int x0 = std::max(0, (x - 1) / 2);
      const int x1 = std::min(mirror_width_ - 1, (x + 1) / 2);
      const float wx = x % 2 == 0 ? 0.75F : 0.25F;
      const auto cell = [&](int cx, int cy) { return mirror_[at(cy * mirror_width_ + cx)]; };
      const V4 sum =
          (cell(x0, y0) * splat(1.0F - wx) + cell(x1, y0) * splat(wx)) * splat(1.0F - wy) +
          (cell(x0, y1) * splat(1.0F - wx) + cell(x1, y1) * splat(wx)) * splat(wy);
      if (sum[3] > 0.0F) pixel += sum * splat(weight / sum[3]);
    }
  }
}

}  // namespace striate::simulator::render
