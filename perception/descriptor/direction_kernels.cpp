#define HWY_WANT_AVX3_DL 1

#include "striate/perception/descriptor/direction_kernels.hpp"

#include <cmath>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "striate/perception/descriptor/direction_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

#ifndef STRIATE_ORIENTATION_VECTORS
#define STRIATE_ORIENTATION_VECTORS
namespace striate::perception::direction_kernels {

/// cos and sin of each orientation.
struct OrientationVectors {
  std::array<float, kOrientations> u{}, v{};
  OrientationVectors() {
    for (std::size_t i = 0; i < kOrientations; ++i) {
      const double theta = static_cast<double>(i) * std::numbers::pi / kOrientations;
      u[i] = static_cast<float>(std::cos(theta));
      v[i] = static_cast<float>(std::sin(theta));
    }
  }
};

}  // namespace striate::perception::direction_kernels
#endif

HWY_BEFORE_NAMESPACE();
namespace striate::perception::direction_kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, kColumns>;
using V = hn::Vec<D>;

/// atan2(v, u) in degrees, 0..360, to 0.01 degrees: a polynomial for the first eighth of a turn.
HWY_INLINE V Angle_deg(V u, V v) {
  const D d;
  const V zero = hn::Zero(d);
  const V along = hn::Abs(u), across = hn::Abs(v);
  const V ratio = hn::Div(hn::Min(along, across),
                          hn::Add(hn::Max(along, across), hn::Set(d, 2.2204460492503131e-16F)));
  const V square = hn::Mul(ratio, ratio);
  // Degrees in a radian: 180 / pi
  constexpr auto kDegrees = static_cast<float>(180.0 / std::numbers::pi);
  V angle = hn::Set(d, -0.04432655554792128F * kDegrees);
  for (const float factor : {0.1555786518463281F, -0.3258083974640975F, 0.9997878412794807F}) {
    angle = hn::Add(hn::Mul(angle, square), hn::Set(d, factor * kDegrees));
  }
  angle = hn::Mul(angle, ratio);
  angle = hn::IfThenElse(hn::Ge(along, across), angle, hn::Sub(hn::Set(d, 90.0F), angle));
  angle = hn::IfThenElse(hn::Lt(u, zero), hn::Sub(hn::Set(d, 180.0F), angle), angle);
  return hn::IfThenElse(hn::Lt(v, zero), hn::Sub(hn::Set(d, 360.0F), angle), angle);
}

/// Pixels x.. of one row.
HWY_INLINE void ShareSome(V u, V v, V weight, std::size_t to, Shares& out) {
  const D d;
  const hn::RebindToSigned<D> d32;
  const V length = hn::Mul(hn::Sqrt(hn::Add(hn::Mul(u, u), hn::Mul(v, v))), weight);
  const V bin = hn::Mul(Angle_deg(u, v), hn::Set(d, static_cast<float>(kBins) / 360.0F));
  const auto low = hn::ConvertTo(d32, bin);
  const V part = hn::Sub(bin, hn::ConvertTo(d, low));
  const auto one = hn::Set(d32, 1), last = hn::Set(d32, kBins - 1), all = hn::Set(d32, kBins);
  auto wrapped = [&](auto number) HWY_ATTR {
    return hn::IfThenElse(hn::Gt(number, last), hn::Sub(number, all), number);
  };
  hn::StoreU(wrapped(low), d32, out.bin.data() + to);
  hn::StoreU(wrapped(hn::Add(low, one)), d32, out.next_bin.data() + to);
  hn::StoreU(hn::Mul(length, hn::Sub(hn::Set(d, 1.0F), part)), d, out.share.data() + to);
  hn::StoreU(hn::Mul(length, part), d, out.next_share.data() + to);
}

void ShareDirections(const pooling_kernels::OddWindow& at, const Weights& weights,
                     const OrientationVectors& vectors, Shares& out) {
  const D d;
  const hn::RebindToSigned<D> d32;
  const hn::Rebind<std::int16_t, D> d16;
  const auto step = hn::Lanes(d);
  for (std::size_t y = 0; y < kSide_px; ++y) {
    const std::ptrdiff_t row =
        (static_cast<std::ptrdiff_t>(y) - kBefore_px) * at.stride - kBefore_px;
    const V down = hn::Set(d, weights.down[y]);
    for (std::size_t x = 0; x < kColumns; x += step) {
      V u = hn::Zero(d), v = hn::Zero(d);
      for (std::size_t i = 0; i < kOrientations; ++i) {
        const auto odd = hn::LoadU(d16, at.odd[i] + row + x);
        const V response = hn::ConvertTo(d, hn::PromoteTo(d32, odd));
        u = hn::Add(u, hn::Mul(response, hn::Set(d, vectors.u[i])));
        v = hn::Add(v, hn::Mul(response, hn::Set(d, vectors.v[i])));
      }
      const V weight = hn::Mul(hn::LoadU(d, weights.across.data() + x), down);
      ShareSome(u, v, weight, y * kColumns + x, out);
    }
  }
}

}  // namespace striate::perception::direction_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate::perception::direction_kernels {

HWY_EXPORT(ShareDirections);

void share_directions(const pooling_kernels::OddWindow& at, const Weights& weights, Shares& out) {
  static const OrientationVectors vectors;
  HWY_DYNAMIC_DISPATCH(ShareDirections)(at, weights, vectors, out);
}

}  // namespace striate::perception::direction_kernels
#endif
