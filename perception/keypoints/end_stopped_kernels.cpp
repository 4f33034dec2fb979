#define HWY_WANT_AVX3_DL 1

#include "striate/perception/keypoints/end_stopped_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "striate/perception/keypoints/end_stopped_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace striate::perception::end_stopped_kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D32 = hn::ScalableTag<std::int32_t>;
using D16 = hn::ScalableTag<std::uint16_t>;
using V16 = hn::Vec<D16>;

void Amplitudes(const std::int16_t* HWY_RESTRICT code, int count, std::uint16_t* HWY_RESTRICT out) {
  const D32 d;
  const hn::Rebind<float, D32> df;
  const hn::Rebind<std::int16_t, D32> d_code;
  const hn::Rebind<std::uint16_t, D32> d_out;
  const auto origin = hn::Set(d, 32768 + (127 << 11));
  const auto one = hn::Set(df, 1.0F), half = hn::Set(df, 0.5F), zero = hn::Zero(df);
  for (int x = 0; x < count; x += static_cast<int>(hn::Lanes(d))) {
    const auto bits = hn::Add(hn::PromoteTo(d, hn::LoadU(d_code, code + x)), origin);
    const auto energy = hn::Sub(hn::BitCast(df, hn::ShiftLeft<12>(bits)), one);
    const auto amplitude = hn::Add(hn::Sqrt(hn::Max(energy, zero)), half);
    hn::StoreU(hn::DemoteTo(d_out, hn::ConvertTo(d, amplitude)), d_out, out + x);
  }
}

HWY_INLINE V16 Weight(std::uint32_t twice) {
#if HWY_TARGET == HWY_SCALAR
  return hn::Set(D16(), static_cast<std::uint16_t>(twice));
#else
  const hn::Repartition<std::uint32_t, D16> d;
  return hn::BitCast(D16(), hn::Set(d, twice));
#endif
}

/// The bilinear sample, halved (weights are in 1/32768); each product is cut off, which 2 makes
/// good on average.
HWY_INLINE V16 Look(const Tap& tap, int x) {
  const D16 d;
  const V16 upper = hn::Add(hn::MulHigh(hn::LoadU(d, tap.upper + x), Weight(tap.weights[0])),
                            hn::MulHigh(hn::LoadU(d, tap.upper + x + 1), Weight(tap.weights[1])));
  const V16 lower = hn::Add(hn::MulHigh(hn::LoadU(d, tap.lower + x), Weight(tap.weights[2])),
                            hn::MulHigh(hn::LoadU(d, tap.lower + x + 1), Weight(tap.weights[3])));
  return hn::Add(hn::Add(upper, lower), hn::Set(d, 2));
}

/// Doubles `value` `times` times, at most to 65535.
HWY_INLINE V16 Double(V16 value, int times, V16 largest) {
  return hn::ShiftLeftSame(hn::Min(value, largest), times);
}

HWY_INLINE V16 Largest(int doublings) {
  return hn::Set(D16(), static_cast<std::uint16_t>(0xFFFF >> doublings));
}

template <bool kSingleStopped>
HWY_INLINE void Respond(const RowJob& job, int width, std::uint16_t* HWY_RESTRICT out) {
  const D16 d;
  const V16 radial_largest = Largest(job.radial_doublings);
  const V16 inhibition = hn::Set(d, job.inhibition);
  const V16 inhibition_largest = Largest(job.inhibition_doublings);
  const int step = static_cast<int>(hn::Lanes(d));
  for (int x = 0; x < width; x += step) {
    V16 single = hn::Zero(d), twice = hn::Zero(d), inhibited = hn::Zero(d);
    for (const OrientationTaps& taps : job.taps) {
      const V16 centre = hn::ShiftRight<1>(hn::LoadU(d, taps.centre + x));
      // Both at most 23172: their sum fits.
      const V16 ends = hn::Add(Look(taps.double_[0], x), Look(taps.double_[1], x));
      twice = hn::SaturatedAdd(twice, hn::SaturatedSub(centre, hn::ShiftRight<1>(ends)));
      for (std::size_t side = 0; side < 2; ++side) {
        const V16 beside = Look(taps.tangential[side], x);
        const V16 across = Double(Look(taps.radial[side], x), job.radial_doublings, radial_largest);
        inhibited = hn::SaturatedAdd(inhibited, hn::SaturatedSub(beside, centre));
        inhibited = hn::SaturatedAdd(inhibited, hn::SaturatedSub(centre, across));
      }
      if constexpr (kSingleStopped) {
        single = hn::SaturatedAdd(
            single, hn::SaturatedSub(Look(taps.single[0], x), Look(taps.single[1], x)));
      }
    }
    const V16 excited = kSingleStopped ? hn::Max(single, twice) : twice;
    const V16 less =
        Double(hn::MulHigh(inhibited, inhibition), job.inhibition_doublings, inhibition_largest);
    hn::StoreU(hn::SaturatedSub(excited, less), d, out + x);
  }
}

void RespondRow(const RowJob& job, int width, std::uint16_t* HWY_RESTRICT out) {
  if (job.single_stopped) {
    Respond<true>(job, width, out);
  } else {
    Respond<false>(job, width, out);
  }
}

}  // namespace striate::perception::end_stopped_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate::perception::end_stopped_kernels {

HWY_EXPORT(Amplitudes);
HWY_EXPORT(RespondRow);

void amplitudes(const std::int16_t* code, int count, std::uint16_t* out) {
  HWY_DYNAMIC_DISPATCH(Amplitudes)(code, count, out);
}

void respond_row(const RowJob& job, int width, std::uint16_t* out) {
  HWY_DYNAMIC_DISPATCH(RespondRow)(job, width, out);
}

}  // namespace striate::perception::end_stopped_kernels
#endif
