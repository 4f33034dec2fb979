#define HWY_WANT_AVX3_DL 1

#include "perception/v1/v1_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "perception/v1/v1_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace striate::v1_kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D32 = hn::ScalableTag<std::int32_t>;
using V32 = hn::Vec<D32>;

/// sum of the two 16-bit products of each 32-bit element.
HWY_INLINE V32 MultiplyPairs(V32 a, V32 b) {
#if HWY_TARGET == HWY_SCALAR
  const V32 low =
      hn::Mul(hn::ShiftRight<16>(hn::ShiftLeft<16>(a)), hn::ShiftRight<16>(hn::ShiftLeft<16>(b)));
  return hn::Add(low, hn::Mul(hn::ShiftRight<16>(a), hn::ShiftRight<16>(b)));
#else
  const hn::Repartition<std::int16_t, D32> d16;
  V32 odd = hn::Zero(D32());
  const V32 even = hn::ReorderWidenMulAccumulate(D32(), hn::BitCast(d16, a), hn::BitCast(d16, b),
                                                 hn::Zero(D32()), odd);
  return hn::RearrangeToOddPlusEven(even, odd);
#endif
}

/// (low, high) as 16-bit halves; both within 16 bits.
HWY_INLINE V32 JoinHalves(V32 low, V32 high) {
  return hn::Or(hn::ShiftLeft<16>(high), hn::And(low, hn::Set(D32(), 0xFFFF)));
}

void PairUp(const std::int16_t* HWY_RESTRICT grey, int radius, int width,
            std::int32_t* HWY_RESTRICT pairs) {
  const D32 d;
  const hn::Rebind<std::int16_t, D32> d16;
  const int step = static_cast<int>(hn::Lanes(d));
  for (int x = -radius; x <= width + radius; x += step) {
    const V32 here = hn::PromoteTo(d, hn::LoadU(d16, grey + x));
    const V32 next = hn::PromoteTo(d, hn::LoadU(d16, grey + x + 1));
    hn::StoreU(JoinHalves(here, next), d, pairs + x);
  }
}

void FilterRows(const std::int32_t* HWY_RESTRICT pairs_a, const std::int32_t* HWY_RESTRICT pairs_b,
                const std::vector<std::int32_t>& taps, int width, std::int32_t* HWY_RESTRICT out) {
  const D32 d;
  const int step = static_cast<int>(hn::Lanes(d));
  const int count = static_cast<int>(taps.size());
  const int radius = count - 1;
  const V32 half = hn::Set(d, 1 << (FilterBank::kRowShift - 1));
  for (int x = 0; x < width; x += 2 * step) {
    V32 a0 = half, a1 = half, b0 = half, b1 = half;
    const std::int32_t* a = pairs_a + x - radius;
    const std::int32_t* b = pairs_b + x - radius;
    for (int k = 0; k < count; ++k, a += 2, b += 2) {
      const V32 tap = hn::Set(d, taps[static_cast<std::size_t>(k)]);
      a0 = hn::Add(a0, MultiplyPairs(hn::LoadU(d, a), tap));
      a1 = hn::Add(a1, MultiplyPairs(hn::LoadU(d, a + step), tap));
      b0 = hn::Add(b0, MultiplyPairs(hn::LoadU(d, b), tap));
      b1 = hn::Add(b1, MultiplyPairs(hn::LoadU(d, b + step), tap));
    }
    constexpr int kShift = FilterBank::kRowShift;
    hn::StoreU(JoinHalves(hn::ShiftRight<kShift>(a0), hn::ShiftRight<kShift>(b0)), d, out + x);
    hn::StoreU(JoinHalves(hn::ShiftRight<kShift>(a1), hn::ShiftRight<kShift>(b1)), d,
               out + x + step);
  }
}

/// The complex cell's 16-bit code: the leading bits of the energy as a floating-point number,
/// that is its logarithm in steps of 2^-11 (at most 0.05 % of the energy).
HWY_INLINE V32 EnergyCode(V32 even, V32 odd) {
  const D32 d;
  const hn::Rebind<float, D32> df;
  const V32 pair = JoinHalves(even, odd);
  const V32 energy = hn::Add(MultiplyPairs(pair, pair), hn::Set(d, 1));
  const V32 bits = hn::BitCast(d, hn::ConvertTo(df, energy));
  return hn::Sub(hn::ShiftRight<12>(bits), hn::Set(d, (127 << 11) + 32768));
}

HWY_INLINE void Finish(V32 even_sum, V32 odd_sum, int x, const Responses& to) {
  const hn::Rebind<std::int16_t, D32> d16;
  const V32 even = hn::ShiftRight<FilterBank::kColumnShift>(even_sum);
  const V32 odd = hn::ShiftRight<FilterBank::kColumnShift>(odd_sum);
  hn::StoreU(hn::DemoteTo(d16, EnergyCode(even, odd)), d16, to.code + x);
  if (to.even != nullptr) hn::StoreU(hn::DemoteTo(d16, even), d16, to.even + x);
  if (to.odd != nullptr) hn::StoreU(hn::DemoteTo(d16, odd), d16, to.odd + x);
}

/// Adds what the products of one slot give at x and x + lanes.
HWY_INLINE void SumSlot(const std::vector<ColumnInput>& inputs, int taps, int x, V32& even0,
                        V32& even1, V32& odd0, V32& odd1) {
  const D32 d;
  const int step = static_cast<int>(hn::Lanes(d));
  for (const ColumnInput& input : inputs) {
    const std::int32_t* HWY_RESTRICT from = input.first + x;
    for (int k = 0; k < taps; ++k, from += input.stride) {
      const V32 even_tap = hn::Set(d, input.even_taps[k]);
      const V32 odd_tap = hn::Set(d, input.odd_taps[k]);
      const V32 r0 = hn::LoadU(d, from);
      const V32 r1 = hn::LoadU(d, from + step);
      even0 = hn::Add(even0, MultiplyPairs(r0, even_tap));
      even1 = hn::Add(even1, MultiplyPairs(r1, even_tap));
      odd0 = hn::Add(odd0, MultiplyPairs(r0, odd_tap));
      odd1 = hn::Add(odd1, MultiplyPairs(r1, odd_tap));
    }
  }
}

void FilterColumns(const ColumnJob& job, int width) {
  const D32 d;
  const int step = static_cast<int>(hn::Lanes(d));
  const V32 half = hn::Set(d, 1 << (FilterBank::kColumnShift - 1));
  const V32 offset = hn::Set(d, job.offset + (1 << (FilterBank::kColumnShift - 1)));
  const V32 box_factor = hn::Set(d, job.box_factor);
  const V32 box_half = hn::Set(d, 1 << (FilterBank::kGreyShift - 1));
  const auto whole_box = [&](int x) {
    return hn::ShiftRight<FilterBank::kGreyShift>(hn::Add(hn::LoadU(d, job.box + x), box_half));
  };
  for (int x = 0; x < width; x += 2 * step) {
    // The mean is the same at theta and pi - theta: it belongs to slot 0.
    V32 even0 = offset, even1 = offset, odd0 = half, odd1 = half;
    if (job.box != nullptr) {
      even0 = hn::Sub(even0, hn::Mul(whole_box(x), box_factor));
      even1 = hn::Sub(even1, hn::Mul(whole_box(x + step), box_factor));
    }
    V32 slot1_even0 = hn::Zero(d), slot1_even1 = hn::Zero(d);
    V32 slot1_odd0 = hn::Zero(d), slot1_odd1 = hn::Zero(d);
    SumSlot(job.slots[0], job.taps, x, even0, even1, odd0, odd1);
    SumSlot(job.slots[1], job.taps, x, slot1_even0, slot1_even1, slot1_odd0, slot1_odd1);
    Finish(hn::Add(even0, slot1_even0), hn::Add(odd0, slot1_odd0), x, job.direct);
    Finish(hn::Add(even1, slot1_even1), hn::Add(odd1, slot1_odd1), x + step, job.direct);
    if (job.mirrored.code != nullptr) {
      Finish(hn::Sub(even0, slot1_even0), hn::Sub(odd0, slot1_odd0), x, job.mirrored);
      Finish(hn::Sub(even1, slot1_even1), hn::Sub(odd1, slot1_odd1), x + step, job.mirrored);
    }
  }
}

void SlideBox(const std::int32_t* add, const std::int32_t* subtract, int width, std::int32_t* box) {
  const D32 d;
  const int step = static_cast<int>(hn::Lanes(d));
  for (int x = 0; x < width; x += step) {
    const V32 change = hn::Sub(hn::LoadU(d, add + x), hn::LoadU(d, subtract + x));
    hn::StoreU(hn::Add(hn::LoadU(d, box + x), change), d, box + x);
  }
}

}  // namespace striate::v1_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate::v1_kernels {

HWY_EXPORT(PairUp);
HWY_EXPORT(FilterRows);
HWY_EXPORT(FilterColumns);
HWY_EXPORT(SlideBox);

void pair_up(const std::int16_t* grey, int radius, int width, std::int32_t* pairs) {
  HWY_DYNAMIC_DISPATCH(PairUp)(grey, radius, width, pairs);
}

void filter_rows(const std::int32_t* pairs_a, const std::int32_t* pairs_b,
                 const std::vector<std::int32_t>& taps, int width, std::int32_t* out) {
  HWY_DYNAMIC_DISPATCH(FilterRows)(pairs_a, pairs_b, taps, width, out);
}

void filter_columns(const ColumnJob& job, int width) {
  HWY_DYNAMIC_DISPATCH(FilterColumns)(job, width);
}

void slide_box(const std::int32_t* add, const std::int32_t* subtract, int width,
               std::int32_t* box) {
  HWY_DYNAMIC_DISPATCH(SlideBox)(add, subtract, width, box);
}

}  // namespace striate::v1_kernels
#endif
