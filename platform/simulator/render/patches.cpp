#include "striate/platform/simulator/render/patches.hpp"

#include <numbers>

namespace striate::simulator::render {
namespace {

int texels_along(float length_m, float spacing_m) {
  const int cells = static_cast<int>(std::ceil(length_m / spacing_m - 0.01F));
  // Odd counts: every second texel, the ends included, carries the indirect light.
  return cells <= 1 ? 2 : cells / 2 * 2 + 1;
}

}  // namespace

Patch& PatchList::quad(const std::array<Vec3, 4>& corner, int material,
                       const std::array<float, 4>& s, const std::array<float, 4>& t) {
  const Material& look = materials_[material];
  Patch patch;
  patch.corner = corner;
  patch.normal = unit(cross(corner[2] - corner[0], corner[3] - corner[1]));
  patch.bend.fill(patch.normal);
  patch.material = material;
  patch.group = group_;
  const float tile_x = look.tile_x_m > 0.0F ? look.tile_x_m : 1.0F;
  const float tile_y = look.tile_y_m > 0.0F ? look.tile_y_m : 1.0F;
  for (std::size_t i = 0; i < 4; ++i) {
    patch.s[i] = s[i] / tile_x;
    patch.t[i] = t[i] / tile_y;
  }
  const float wide = std::max(length(corner[1] - corner[0]), length(corner[2] - corner[3]));
  const float tall = std::max(length(corner[3] - corner[0]), length(corner[2] - corner[1]));
  const float ds = std::abs(patch.s[1] - patch.s[0]) + std::abs(patch.t[1] - patch.t[0]);
  patch.texels_per_m = static_cast<float>(look.texture->width()) * ds / std::max(wide, 1e-4F);
  patch.light_u = texels_along(wide, spacing_m_);
  patch.light_v = texels_along(tall, spacing_m_);
  patch.light_at = light_texels_;
  light_texels_ += patch.light_u * patch.light_v;
  patches_.push_back(patch);
  return patches_.back();
}

Patch& PatchList::rectangle(Vec3 corner, Vec3 along, Vec3 up, int material, float s_m) {
  const bool stretched = materials_[material].tile_x_m <= 0.0F;
  const float right = stretched ? 0.998F : s_m + length(along);
  const float left = stretched ? 0.002F : s_m;
  const float low = stretched ? 0.998F : -corner.z;
  const float high = stretched ? 0.002F : low - length(up);
  return quad({corner, corner + along, corner + along + up, corner + up}, material,
              {left, right, right, left}, {low, low, high, high});
}

void PatchList::block(const Stand& stand, const Block& block, int side_material, int top_material,
                      bool with_bottom) {
  const Vec3 a = block.low;
  const Vec3 b = block.high;
  const std::array<std::array<float, 2>, 4> foot{{{a.x, a.y}, {b.x, a.y}, {b.x, b.y}, {a.x, b.y}}};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& from = foot[i];
    const auto& to = foot[(i + 1) % 4];
    const Vec3 corner = stand.point(from[0], from[1], a.z);
    next_group();
    rectangle(corner, stand.point(to[0], to[1], a.z) - corner, {0.0F, 0.0F, b.z - a.z},
              side_material, from[0] + from[1]);
  }
  next_group();
  const Vec3 top = stand.point(a.x, a.y, b.z);
  rectangle(top, stand.point(b.x, a.y, b.z) - top, stand.point(a.x, b.y, b.z) - top, top_material);
  if (with_bottom) {
    next_group();
    const Vec3 low = stand.point(a.x, a.y, a.z);
    rectangle(low, stand.point(a.x, b.y, a.z) - low, stand.point(b.x, a.y, a.z) - low,
              top_material);
  }
}

void PatchList::column(const Stand& stand, const Column& c, int material) {
  const bool stretched = materials_[material].tile_x_m <= 0.0F;
  const auto sides = static_cast<float>(c.sides);
  const float round_m = 2.0F * std::numbers::pi_v<float> * std::max(c.bottom_rx_m, c.top_rx_m);
  const auto ring = [&](int i, bool top) {
    const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / sides;
    const float rx = top ? c.top_rx_m : c.bottom_rx_m;
    const float ry = top ? c.top_ry_m : c.bottom_ry_m;
    return stand.point(c.x_m + rx * std::cos(angle), c.y_m + ry * std::sin(angle),
                       top ? c.top_m : c.bottom_m);
  };
  next_group();
  for (int i = 0; i < c.sides; ++i) {
    const float from = static_cast<float>(i) / sides * (stretched ? 1.0F : round_m);
    const float to = static_cast<float>(i + 1) / sides * (stretched ? 1.0F : round_m);
    const float low = stretched ? 0.998F : -c.bottom_m;
    const float high = stretched ? 0.002F : -c.top_m;
    Patch& side = quad({ring(i, false), ring(i + 1, false), ring(i + 1, true), ring(i, true)},
                       material, {from, to, to, from}, {low, low, high, high});
    const auto out = [&](int k) {
      const Vec3 middle = stand.point(c.x_m, c.y_m, c.bottom_m);
      const Vec3 radial = ring(k, false) - middle;
      return unit({radial.x, radial.y, side.normal.z});
    };
    side.bend = {out(i), out(i + 1), out(i + 1), out(i)};
  }
  if (!c.lid) return;
  next_group();
  const auto flat = [&](Vec3 p, bool y) { return y ? p.y : p.x; };
  for (int i = 0; i + 2 < c.sides; i += 2) {  // a fan of quadrilaterals around corner 0
    const std::array<Vec3, 4> q{ring(0, true), ring(i + 1, true),
                                ring(std::min(i + 2, c.sides), true),
                                ring(std::min(i + 3, c.sides), true)};
    const float k = stretched ? 0.0F : 1.0F;
    quad(q, material,
         {k * flat(q[0], false), k * flat(q[1], false), k * flat(q[2], false),
          k * flat(q[3], false)},
         {k * flat(q[0], true), k * flat(q[1], true), k * flat(q[2], true), k * flat(q[3], true)});
  }
}

}  // namespace striate::simulator::render
