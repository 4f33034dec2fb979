#define HWY_WANT_AVX3_DL 1

#include "striate/platform/simulator/render/read_out_kernel.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "striate/platform/simulator/render/read_out_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace striate::simulator::render::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::ScalableTag<float>;
using DU = hn::RebindToUnsigned<DF>;
using DI = hn::RebindToSigned<DF>;
using VF = hn::Vec<DF>;
using VU = hn::Vec<DU>;
using VI = hn::Vec<DI>;

/// mix of noise.hpp
HWY_INLINE VU Mix(VU x) {
  const DU du;
  x = hn::Xor(x, hn::ShiftRight<16>(x));
  x = hn::Mul(x, hn::Set(du, 0x7FEB352DU));
  x = hn::Xor(x, hn::ShiftRight<15>(x));
  x = hn::Mul(x, hn::Set(du, 0x846CA68BU));
  return hn::Xor(x, hn::ShiftRight<16>(x));
}

/// @return how many pixels were done; the rest of the row is less than a vector.
int ReadOutWhole(const ReadOutRow& row, const float* gauss, const float* light,
                 const float* sensitivity, int width, float* out) {
  const DF df;
  const DU du;
  const DI di;
  const int step = static_cast<int>(hn::Lanes(df));
  if (step < 2) return 0;
  HWY_ALIGN std::array<std::int32_t, hn::MaxLanes(df)> colours;
  HWY_ALIGN std::array<float, hn::MaxLanes(df)> filters;
  for (std::size_t i = 0; i < colours.size(); ++i) {
    colours[i] = row.colour[i % 2];
    filters[i] = row.filter[i % 2];
  }
  const VI colour = hn::LoadU(di, colours.data());
  const VF filter = hn::LoadU(df, filters.data());
  const VF full = hn::Set(df, row.full_well_e);
  const VF level = hn::Mul(full, filter);
  int x = 0;
  for (; x + step <= width; x += step) {
    const VI number = hn::Iota(di, x);
    const VF seen = hn::GatherIndex(df, light, hn::Add(hn::ShiftLeft<2>(number), colour));
    const VF caught = hn::Mul(
        hn::Mul(hn::Mul(seen, hn::Set(df, row.electrons)), hn::LoadU(df, sensitivity + x)), filter);
    const VF mean = hn::Min(full, caught);
    const VF sigma = hn::Sqrt(hn::Add(mean, hn::Set(df, row.read_variance_e2)));
    const VU hash = Mix(hn::Add(hn::Set(du, row.noise_key),
                                hn::Mul(hn::BitCast(du, number), hn::Set(du, 0x9E3779B9U))));
    const VI place = hn::BitCast(di, hn::ShiftRight<32 - GaussTable::kBits>(hash));
    const VF normal = hn::GatherIndex(df, gauss, place);
    const VF counted = hn::Add(mean, hn::Mul(hn::Mul(hn::Set(df, row.noise), sigma), normal));
    const VF grey = hn::Div(hn::Mul(counted, hn::Set(df, row.gain)), level);
    hn::StoreU(hn::Min(hn::Set(df, 1.0F), grey), df, out + x);
  }
  return x;
}

}  // namespace striate::simulator::render::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate::simulator::render {

HWY_EXPORT(ReadOutWhole);

void read_out_row(const ReadOutRow& row, const GaussTable& gauss, const V4* light,
                  const float* sensitivity, int width, float* out) {
  int x = HWY_DYNAMIC_DISPATCH(ReadOutWhole)(
      row, gauss.values(), reinterpret_cast<const float*>(light), sensitivity, width, out);
  for (; x < width; ++x) out[x] = read_out_pixel(row, gauss, light, sensitivity, x);
}

}  // namespace striate::simulator::render
#endif
