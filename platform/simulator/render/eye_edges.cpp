#include "striate/platform/simulator/render/eye_image.hpp"

namespace striate::simulator::render {
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

}  // namespace striate::simulator::render
