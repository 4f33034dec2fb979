#include "striate/platform/simulator/render/eye_image.hpp"

namespace striate::simulator::render {
namespace {

/// Nothing comes nearer to the eyes: they stand 0.2 m within the robot's outline
constexpr float kNear_m = 0.03F;
constexpr float kFar_m = 300.0F;  // farther than any corridor is long

std::size_t at(int i) {
  return static_cast<std::size_t>(i);
}

}  // namespace

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

/// Marks pixels here + i and there + i, i < count, where a visible step lies between them.
void EyeImage::mark_steps(std::size_t here, std::size_t there, int count) {
  const float* __restrict brightness = brightness_.data();
  const int* __restrict group = group_.data();
  int* __restrict step = step_.data();
  for (int i = 0; i < count; ++i) {
    const float a = brightness[here + at(i)];
    const float b = brightness[there + at(i)];
    const float needed = group[here + at(i)] == group[there + at(i)] ? 0.6F : 0.2F;
    step[i] = std::abs(a - b) > needed * std::max(a, b) ? 1 : 0;
  }
  int* edge = is_edge_.data();
  for (int i = 0; i < count; ++i) edge[here + at(i)] |= step[i];
  for (int i = 0; i < count; ++i) edge[there + at(i)] |= step[i];
}

/// Pixels beside a visible step of brightness, on both sides of it.
std::vector<int> EyeImage::edges(const View& view) {
  const int w = view.width_px;
  const std::size_t pixels = light_.size();
  brightness_.resize(pixels);
  is_edge_.assign(pixels, 0);
  step_.resize(at(w));
  for (std::size_t i = 0; i < pixels; ++i) brightness_[i] = luminance(light_[i]);
  for (int y = 0; y < view.height_px; ++y) {
    const std::size_t row = at(y * w);
    mark_steps(row, row + 1, w - 1);
    if (y + 1 < view.height_px) mark_steps(row, row + at(w), w);
  }
  // Tile by tile, so that rays that are traced together go nearly the same way.
  constexpr int kTile_px = 8;
  std::vector<int> found;
  for (int top = 0; top < view.height_px; top += kTile_px) {
    for (int left = 0; left < w; left += kTile_px) {
      for (int y = top; y < std::min(top + kTile_px, view.height_px); ++y) {
        for (int x = left; x < std::min(left + kTile_px, w); ++x) {
          if (is_edge_[at(y * w + x)] != 0) found.push_back(y * w + x);
        }
      }
    }
  }
  return found;
}

/// Eight pixels, each with two rays more beside the one it has.
void EyeImage::resample(const View& view, const std::vector<int>& pixels, std::size_t first) {
  // Of a pixel: with the ray in the middle, thirds of it across
  static constexpr std::array<float, 2> kU{-0.33F, 0.33F};
  // Of a pixel: with the ray in the middle, a third of it down
  static constexpr std::array<float, 2> kV{-0.17F, 0.17F};
  const std::size_t count = std::min<std::size_t>(8, pixels.size() - first);
  Packet packet;
  packet.start(view.origin, kNear_m, kFar_m);
  int left = view.width_px;
  int right = 0;
  int top = view.height_px;
  int bottom = 0;
  for (unsigned i = 0; i < Packet::kSize; ++i) {
    const int pixel = pixels[first + std::min<std::size_t>(i / 2, count - 1)];
    const int x = pixel % view.width_px;
    const int y = pixel / view.width_px;
    left = std::min(left, x);
    right = std::max(right, x);
    top = std::min(top, y);
    bottom = std::max(bottom, y);
    // Mirrored from row to row, so that neighbours do not sample the same places.
    const float u = (y % 2 == 0 ? 1.0F : -1.0F) * kU[i % 2];
    packet.aim(i, view.ray(static_cast<float>(x) + u, static_cast<float>(y) + kV[i % 2]));
    if (i / 2 >= count) packet.valid[i] = 0;
  }
  tracer_.intersect(packet, true, people_in(left, top, right, bottom));
  std::array<Shaded, Packet::kSize> shaded;
  shader_.shade(packet, 1.0F / view.focal_px, nullptr, shaded.data());
  for (std::size_t k = 0; k < count; ++k) {
    V4& pixel = light_[at(pixels[first + k])];
    pixel = (pixel + shaded[2 * k].colour + shaded[2 * k + 1].colour) * splat(1.0F / 3.0F);
  }
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
