#define HWY_WANT_AVX3_DL 1

#include "perception/keypoints/end_stopped.hpp"

#include <cmath>
#include <numbers>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "perception/keypoints/end_stopped.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace striate::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::ScalableTag<float>;
using VF = hn::Vec<DF>;

HWY_INLINE VF Look(const float* HWY_RESTRICT at, int stride, const Sample& sample) {
  const DF df;
  const float* from = at + sample.dv * stride + sample.du;
  const VF upper = hn::Add(hn::Mul(hn::Set(df, sample.weights[0]), hn::LoadU(df, from)),
                           hn::Mul(hn::Set(df, sample.weights[1]), hn::LoadU(df, from + 1)));
  from += stride;
  const VF lower = hn::Add(hn::Mul(hn::Set(df, sample.weights[2]), hn::LoadU(df, from)),
                           hn::Mul(hn::Set(df, sample.weights[3]), hn::LoadU(df, from + 1)));
  return hn::Add(upper, lower);
}

HWY_INLINE VF Positive(VF value) {
  return hn::Max(value, hn::Zero(DF()));
}

/// One row; planes[i] points to C_i at column 0.
void EndStoppedRow(const std::array<const float*, kOrientations>& planes, int stride, int width,
                   const EndStoppedGeometry& g, float* HWY_RESTRICT out) {
  const DF df;
  const VF half = hn::Set(df, 0.5F);
  const VF radial_factor = hn::Set(df, g.radial_factor);
  const VF inhibition = hn::Set(df, g.inhibition);
  const int step = static_cast<int>(hn::Lanes(df));
  for (int x = 0; x < width; x += step) {
    VF single = hn::Zero(df), twice = hn::Zero(df), inhibited = hn::Zero(df);
    for (std::size_t i = 0; i < kOrientations; ++i) {
      const EndStoppedGeometry::Places& p = g.places[i];
      const float* at = planes[i] + x;
      const float* across = planes[(i + kOrientations / 2) % kOrientations] + x;
      const VF centre = hn::LoadU(df, at);
      single = hn::Add(
          single, Positive(hn::Sub(Look(at, stride, p.single[0]), Look(at, stride, p.single[1]))));
      const VF ends = hn::Add(Look(at, stride, p.double_[0]), Look(at, stride, p.double_[1]));
      twice = hn::Add(twice, Positive(hn::Sub(centre, hn::Mul(half, ends))));
      for (std::size_t side = 0; side < 2; ++side) {
        inhibited =
            hn::Add(inhibited, Positive(hn::Sub(Look(at, stride, p.tangential[side]), centre)));
        const VF crossing = hn::Mul(radial_factor, Look(across, stride, p.radial[side]));
        inhibited = hn::Add(inhibited, Positive(hn::Sub(centre, crossing)));
      }
    }
    hn::StoreU(hn::Sub(hn::Max(single, twice), hn::Mul(inhibition, inhibited)), df, out + x);
  }
}

}  // namespace striate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate {
namespace {

Sample sample_at(double u, double v) {
  // Without the nudge, 2.4 * sin(pi) would ask for the pixel at -1e-16.
  const double left = std::floor(u + 1e-9), top = std::floor(v + 1e-9);
  const double right = std::max(0.0, u - left), bottom = std::max(0.0, v - top);
  // Weights in 1/4096: not at the mercy of the mathematics library's last bit.
  auto weight = [](double w) { return static_cast<float>(std::round(w * 4096.0) / 4096.0); };
  return {static_cast<int>(left),
          static_cast<int>(top),
          {weight((1 - right) * (1 - bottom)), weight(right * (1 - bottom)),
           weight((1 - right) * bottom), weight(right * bottom)}};
}

}  // namespace

EndStoppedGeometry end_stopped_geometry(double wavelength_px, double inhibition,
                                        double radial_factor) {
  EndStoppedGeometry geometry;
  const double d = 0.6 * wavelength_px;
  for (std::size_t i = 0; i < kOrientations; ++i) {
    const double theta = static_cast<double>(i) * std::numbers::pi / kOrientations;
    const double c = std::cos(theta), s = std::sin(theta);
    EndStoppedGeometry::Places& p = geometry.places[i];
    p.single = {sample_at(d * s, -d * c), sample_at(-d * s, d * c)};
    p.double_ = {sample_at(2 * d * s, -2 * d * c), sample_at(-2 * d * s, 2 * d * c)};
    p.tangential = {sample_at(d * c, d * s), sample_at(-d * c, -d * s)};
    p.radial = {sample_at(d / 2 * c, d / 2 * s), sample_at(-d / 2 * c, -d / 2 * s)};
  }
  geometry.inhibition = static_cast<float>(inhibition);
  geometry.radial_factor = static_cast<float>(radial_factor);
  geometry.reach = static_cast<int>(std::ceil(2 * d)) + 2;
  return geometry;
}

void complex_planes(const V1Responses& responses, ComplexPlanes& out) {
  const int margin = responses.margin();
  for (std::size_t i = 0; i < kOrientations; ++i) {
    out[i].resize(responses.width, responses.height, margin, margin);
    for (int y = -margin; y < responses.height + margin; ++y) {
      const std::int16_t* from = responses.code[i].row(y);
      float* to = out[i].row(y);
      for (int x = -margin; x < responses.width + margin; ++x) to[x] = complex_response(from[x]);
    }
  }
}

HWY_EXPORT(EndStoppedRow);

void end_stopped_response(const ComplexPlanes& complex, const EndStoppedGeometry& geometry,
                          Plane<float>& out) {
  out.resize(complex[0].width(), complex[0].height(), 0, 0);
  for (int y = 0; y < out.height(); ++y) {
    std::array<const float*, kOrientations> rows{};
    for (std::size_t i = 0; i < kOrientations; ++i) rows[i] = complex[i].row(y);
    HWY_DYNAMIC_DISPATCH(EndStoppedRow)
    (rows, complex[0].stride(), out.width(), geometry, out.row(y));
  }
}

}  // namespace striate
#endif
