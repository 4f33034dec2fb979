#define HWY_WANT_AVX3_DL 1

#include "striate/platform/simulator/render/packet_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "striate/platform/simulator/render/packet_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace striate::simulator::render::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::CappedTag<float, kPacket>;
using DI = hn::RebindToSigned<DF>;
using VF = hn::Vec<DF>;
using VI = hn::Vec<DI>;

/// Texels and weights of the bilinear sample, one entry a lane; room to load past the last.
struct alignas(64) Taps {
  std::array<std::uint32_t, kPacket> texel[4];  ///< upper left and right, lower left and right
  std::array<float, 2 * kPacket> u;
  std::array<float, 2 * kPacket> v;
};

/// Patch::at
HWY_INLINE VF At(const std::array<float, 4>& c, VF u, VF v) {
  const DF df;
  const VF one = hn::Set(df, 1.0F);
  const auto from = [&](int corner, int along_u, int along_v, VF a, VF b) {
    const VF first =
        hn::Add(hn::Set(df, c[corner]), hn::Mul(hn::Set(df, c[along_u] - c[corner]), a));
    return hn::Add(first, hn::Mul(hn::Set(df, c[along_v] - c[corner]), b));
  };
  return hn::IfThenElse(hn::Le(hn::Add(u, v), one), from(0, 1, 3, u, v),
                        from(2, 3, 1, hn::Sub(one, u), hn::Sub(one, v)));
}

/// Fixed point with eight bits of fraction, as Texture::sample has it.
HWY_INLINE VI Fixed(VF place, VF scale) {
  const DF df;
  const DI di;
  const VF part = hn::Sub(place, hn::ConvertTo(df, hn::ConvertTo(di, place)));
  const VF scaled = hn::Mul(hn::Add(part, hn::Set(df, 1.0F)), scale);
  return hn::Sub(hn::ConvertTo(di, scaled), hn::Set(di, 128));
}

HWY_INLINE VI Across(VI x) {
  return hn::Or(hn::ShiftLeft<4>(hn::ShiftRight<2>(x)), hn::And(x, hn::Set(DI(), 3)));
}
HWY_INLINE VI Down(VI y, VI shift) {
  return hn::Or(hn::Shl(hn::ShiftRight<2>(y), shift),
                hn::ShiftLeft<2>(hn::And(y, hn::Set(DI(), 3))));
}

HWY_INLINE void FindTaps(const PacketTexture& surface, const float* u, const float* v,
                         const std::uint32_t* texels, Taps& taps) {
  const DF df;
  const DI di;
  const hn::RebindToUnsigned<DF> du;
  const Texture::Level& even = *surface.level[0];
  const Texture::Level& odd = *surface.level[1];
  const VI one = hn::Set(di, 1);
  const VI fraction = hn::Set(di, 255);
  for (int lane = 0; lane < kPacket; lane += static_cast<int>(hn::Lanes(df))) {
    const VI number = hn::Iota(di, lane);
    const auto is_odd = hn::TestBit(hn::Xor(number, hn::ShiftRight<2>(number)), one);
    const auto of_floats = hn::RebindMask(df, is_odd);
    const auto whole = [&](int a, int b) {
      return hn::IfThenElse(is_odd, hn::Set(di, b), hn::Set(di, a));
    };
    const auto real = [&](float a, float b) {
      return hn::IfThenElse(of_floats, hn::Set(df, b), hn::Set(df, a));
    };
    const VF at_u = hn::LoadU(df, u + lane);
    const VF at_v = hn::LoadU(df, v + lane);
    const VI x = Fixed(At(surface.s, at_u, at_v), real(even.scale_u, odd.scale_u));
    const VI y = Fixed(At(surface.t, at_u, at_v), real(even.scale_v, odd.scale_v));
    const VF share = hn::Set(df, 1.0F / 256.0F);
    hn::StoreU(hn::Mul(hn::ConvertTo(df, hn::And(x, fraction)), share), df, taps.u.data() + lane);
    hn::StoreU(hn::Mul(hn::ConvertTo(df, hn::And(y, fraction)), share), df, taps.v.data() + lane);
    const VI mask_u = whole(even.mask_u, odd.mask_u);
    const VI mask_v = whole(even.mask_v, odd.mask_v);
    const VI shift = whole(even.shift, odd.shift);
    const VI offset = whole(static_cast<int>(even.offset), static_cast<int>(odd.offset));
    const VI left = Across(hn::And(hn::ShiftRight<8>(x), mask_u));
    const VI right = Across(hn::And(hn::Add(hn::ShiftRight<8>(x), one), mask_u));
    const VI top = hn::Add(offset, Down(hn::And(hn::ShiftRight<8>(y), mask_v), shift));
    const VI low =
        hn::Add(offset, Down(hn::And(hn::Add(hn::ShiftRight<8>(y), one), mask_v), shift));
    const VI place[4] = {hn::Add(top, left), hn::Add(top, right), hn::Add(low, left),
                         hn::Add(low, right)};
    for (int k = 0; k < 4; ++k) {
      hn::StoreU(hn::GatherIndex(du, texels, place[k]), du, taps.texel[k].data() + lane);
    }
  }
}

#if HWY_TARGET == HWY_SCALAR

void Blend(const Taps& taps, V4* albedo) {
  for (std::size_t i = 0; i < kPacket; ++i) {
    const auto texel = [&](int k) { return unpacked(taps.texel[k][i]); };
    const V4 value =
        lerp(lerp(texel(0), texel(1), taps.u[i]), lerp(texel(2), texel(3), taps.u[i]), taps.v[i]);
    albedo[i] = value * value * splat(1.0F / (255.0F * 255.0F));
  }
}

#else

HWY_INLINE VF Lerp(VF a, VF b, VF weight) {
  return hn::Add(a, hn::Mul(hn::Sub(b, a), weight));
}

/// Texels are four bytes, colours four floats: a vector holds a quarter as many pixels as lanes.
HWY_INLINE void Blend(const Taps& taps, V4* albedo) {
  const DF df;
  const DI di;
  const hn::Rebind<std::uint8_t, DF> bytes;
  const int pixels = static_cast<int>(hn::Lanes(df)) / 4;
  HWY_ALIGN std::int32_t fourfold[kPacket];
  for (int i = 0; i < kPacket; ++i) fourfold[i] = i / 4;
  const auto spread = hn::SetTableIndices(df, fourfold);
  const VF share = hn::Set(df, 1.0F / (255.0F * 255.0F));
  auto* out = reinterpret_cast<float*>(albedo);
  for (int p = 0; p < kPacket; p += pixels) {
    const auto texels = [&](int k) {
      const auto* from = reinterpret_cast<const std::uint8_t*>(taps.texel[k].data() + p);
      return hn::ConvertTo(df, hn::PromoteTo(di, hn::LoadU(bytes, from)));
    };
    const VF u = hn::TableLookupLanes(hn::LoadU(df, taps.u.data() + p), spread);
    const VF v = hn::TableLookupLanes(hn::LoadU(df, taps.v.data() + p), spread);
    const VF value = Lerp(Lerp(texels(0), texels(1), u), Lerp(texels(2), texels(3), u), v);
    hn::StoreU(hn::Mul(hn::Mul(value, value), share), df, out + 4 * p);
  }
}

#endif

void SamplePacket(const PacketTexture& surface, const float* u, const float* v,
                  const std::uint32_t* texels, V4* albedo) {
  Taps taps;
  FindTaps(surface, u, v, texels, taps);
  Blend(taps, albedo);
}

void LightPacket(const PacketLight& map, const float* u, const float* v, V4* light) {
  const DF df;
  const DI di;
  alignas(64) std::array<std::int32_t, kPacket> cell;
  alignas(64) std::array<float, kPacket> right;
  alignas(64) std::array<float, kPacket> low;
  for (int lane = 0; lane < kPacket; lane += static_cast<int>(hn::Lanes(df))) {
    const VF x = hn::Mul(hn::LoadU(df, u + lane), hn::Set(df, static_cast<float>(map.across - 1)));
    const VF y = hn::Mul(hn::LoadU(df, v + lane), hn::Set(df, static_cast<float>(map.down - 1)));
    const VI i = hn::Min(hn::ConvertTo(di, x), hn::Set(di, map.across - 2));
    const VI j = hn::Min(hn::ConvertTo(di, y), hn::Set(di, map.down - 2));
    hn::StoreU(hn::Sub(x, hn::ConvertTo(df, i)), df, right.data() + lane);
    hn::StoreU(hn::Sub(y, hn::ConvertTo(df, j)), df, low.data() + lane);
    hn::StoreU(hn::Add(hn::Mul(j, hn::Set(di, map.across)), i), di, cell.data() + lane);
  }
  for (std::size_t k = 0; k < kPacket; ++k) {
    const V4* at = map.texels + cell[k];
    const V4* below = at + map.across;
    light[k] = lerp(lerp(at[0], at[1], right[k]), lerp(below[0], below[1], right[k]), low[k]);
  }
}

void MirrorPacket(float gloss, Vec3 normal, const float* xs, const float* ys, const float* zs,
                  float* mirror) {
  const DF df;
  for (int lane = 0; lane < kPacket; lane += static_cast<int>(hn::Lanes(df))) {
    const VF x = hn::LoadU(df, xs + lane);
    const VF y = hn::LoadU(df, ys + lane);
    const VF z = hn::LoadU(df, zs + lane);
    const auto dot = [&](VF a, VF b, VF c) {
      return hn::Add(hn::Add(hn::Mul(x, a), hn::Mul(y, b)), hn::Mul(z, c));
    };
    const VF along = dot(hn::Set(df, normal.x), hn::Set(df, normal.y), hn::Set(df, normal.z));
    const VF facing = hn::Div(hn::Abs(along), hn::Sqrt(dot(x, y, z)));
    const VF k = hn::Sub(hn::Set(df, 1.0F), facing);
    const VF k2 = hn::Mul(k, k);
    const VF fifth = hn::Mul(hn::Mul(hn::Mul(hn::Set(df, 0.96F), k2), k2), k);
    hn::StoreU(hn::Mul(hn::Set(df, gloss), hn::Add(hn::Set(df, 0.04F), fifth)), df, mirror + lane);
  }
}

void AimPacket(const View& view, int left, int top, float* xs, float* ys, float* zs) {
  const DF df;
  const DI di;
  const VF focal = hn::Set(df, view.focal_px);
  for (int lane = 0; lane < kPacket; lane += static_cast<int>(hn::Lanes(df))) {
    const VI number = hn::Iota(di, lane);
    const VI column = hn::Add(hn::Set(di, left), hn::And(number, hn::Set(di, 3)));
    const VI row = hn::Add(hn::Set(di, top), hn::ShiftRight<2>(number));
    const VF u = hn::Sub(hn::ConvertTo(df, column), hn::Set(df, view.centre_u_px));
    const VF v = hn::Sub(hn::ConvertTo(df, row), hn::Set(df, view.centre_v_px));
    const VF shifted = hn::Add(
        hn::Add(hn::Add(v, hn::Set(df, view.skew_px)), hn::Mul(hn::Set(df, view.skew_by_u), u)),
        hn::Mul(hn::Set(df, view.skew_by_v), v));
    const VF across = hn::Div(u, focal);
    const VF below = hn::Div(shifted, focal);
    const auto ray = [&](float forward, float right, float down) {
      return hn::Add(hn::Add(hn::Set(df, forward), hn::Mul(hn::Set(df, right), across)),
                     hn::Mul(hn::Set(df, down), below));
    };
    hn::StoreU(ray(view.forward.x, view.right.x, view.down.x), df, xs + lane);
    hn::StoreU(ray(view.forward.y, view.right.y, view.down.y), df, ys + lane);
    hn::StoreU(ray(view.forward.z, view.right.z, view.down.z), df, zs + lane);
  }
}

}  // namespace striate::simulator::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate::simulator::render {

HWY_EXPORT(SamplePacket);
HWY_EXPORT(LightPacket);
HWY_EXPORT(MirrorPacket);
HWY_EXPORT(AimPacket);

void sample_packet(const PacketTexture& surface, const float* u, const float* v, V4* albedo) {
  HWY_DYNAMIC_DISPATCH(SamplePacket)(surface, u, v, surface.texture->texels(), albedo);
}

void light_packet(const PacketLight& map, const float* u, const float* v, V4* light) {
  HWY_DYNAMIC_DISPATCH(LightPacket)(map, u, v, light);
}

void mirror_packet(float gloss, Vec3 normal, const float* x, const float* y, const float* z,
                   float* mirror) {
  HWY_DYNAMIC_DISPATCH(MirrorPacket)(gloss, normal, x, y, z, mirror);
}

void aim_packet(const View& view, int left, int top, float* x, float* y, float* z) {
  HWY_DYNAMIC_DISPATCH(AimPacket)(view, left, top, x, y, z);
}

}  // namespace striate::simulator::render
#endif
