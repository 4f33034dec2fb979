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

/// sum + the two 16-bit products of each 32-bit element.
HWY_INLINE V32 MultiplyAddPairs(V32 sum, V32 a, V32 b) {
#if HWY_TARGET == HWY_AVX3_DL
  // One instruction of this target (AVX512_VNNI), which Highway 1.0 neither has nor lets the
  // compiler use; the sum stays where it is.
  asm("vpdpwssd %2, %1, %0" : "+v"(sum.raw) : "v"(a.raw), "v"(b.raw));
  return sum;
#else
  return hn::Add(sum, MultiplyPairs(a, b));
#endif
}

/// (low, high) as 16-bit halves; both within 16 bits.
HWY_INLINE V32 JoinHalves(V32 low, V32 high) {
  return hn::Or(hn::ShiftLeft<16>(high), hn::And(low, hn::Set(D32(), 0xFFFF)));
}

/// grey[x + k] + grey[x - k], or the difference.
HWY_INLINE void FoldAt(const std::int16_t* HWY_RESTRICT grey, int k, V32& sum, V32& difference) {
  const D32 d;
  const hn::Rebind<std::int16_t, D32> d16;
  const V32 right = hn::PromoteTo(d, hn::LoadU(d16, grey + k));
  const V32 left = hn::PromoteTo(d, hn::LoadU(d16, grey - k));
  sum = hn::Add(right, left);
  difference = hn::Sub(right, left);
}

void FoldRow(const std::int16_t* grey, int radius, int width, const FoldedRow& out) {
  const D32 d;
  const hn::Rebind<std::int16_t, D32> d16;
  const int step = static_cast<int>(hn::Lanes(d));
  for (int x = 0; x < width; x += step) {
    V32 even = hn::PromoteTo(d, hn::LoadU(d16, grey + x));
    V32 odd = hn::Zero(d);
    // The last pairs may hold one value too many: its tap is zero.
    for (int k = 1; k <= radius + 1; ++k) {
      V32 sum, difference;
      FoldAt(grey + x, k, sum, difference);
      if (k % 2 == 1) {
        hn::StoreU(JoinHalves(even, sum), d, out.even + (k / 2) * out.stride + x);
        odd = difference;
      } else {
        even = sum;
        hn::StoreU(JoinHalves(odd, difference), d, out.odd + (k / 2 - 1) * out.stride + x);
      }
    }
  }
}

void FilterRows(const FoldedRow& row_a, const FoldedRow& row_b, const RowTaps& taps, int width,
                std::int32_t* HWY_RESTRICT out) {
  const D32 d;
  const int step = static_cast<int>(hn::Lanes(d));
  const int count = static_cast<int>(taps.pairs.size());
  const std::int32_t* HWY_RESTRICT tap = taps.pairs.data();
  const V32 half = hn::Set(d, 1 << (FilterBank::kRowShift - 1));
  for (int x = 0; x < width; x += 2 * step) {
    V32 a0 = half, a1 = half, b0 = half, b1 = half;
    const std::int32_t* a = (taps.even ? row_a.even : row_a.odd) + x;
    const std::int32_t* b = (taps.even ? row_b.even : row_b.odd) + x;
    for (int k = 0; k < count; ++k, a += row_a.stride, b += row_b.stride) {
      const V32 t = hn::Set(d, tap[k]);
      a0 = MultiplyAddPairs(a0, hn::LoadU(d, a), t);
      a1 = MultiplyAddPairs(a1, hn::LoadU(d, a + step), t);
      b0 = MultiplyAddPairs(b0, hn::LoadU(d, b), t);
      b1 = MultiplyAddPairs(b1, hn::LoadU(d, b + step), t);
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
  if (to.code != nullptr) hn::StoreU(hn::DemoteTo(d16, EnergyCode(even, odd)), d16, to.code + x);
  if (to.even != nullptr) hn::StoreU(hn::DemoteTo(d16, even), d16, to.even + x);
  if (to.odd != nullptr) hn::StoreU(hn::DemoteTo(d16, odd), d16, to.odd + x);
}

HWY_INLINE void FinishOdd(V32 odd_sum, int x, const Responses& to) {
  const hn::Rebind<std::int16_t, D32> d16;
  const V32 odd = hn::ShiftRight<FilterBank::kColumnShift>(odd_sum);
  hn::StoreU(hn::DemoteTo(d16, odd), d16, to.odd + x);
}

#undef FEW_REGISTERS
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
#define FEW_REGISTERS 1
#else
#define FEW_REGISTERS 0
#endif

// What is summed up at a time, rows x vectors, even and odd, fits into 32 or 16 registers.
constexpr int kVectors = 4;
constexpr int kRowsInRegisters = HWY_TARGET <= HWY_AVX3 ? 2 : 1;
/// With few registers GCC 12 moves every sum at the end of a loop's body: half as often so.
constexpr std::size_t kTapsAtOnce = FEW_REGISTERS ? 2 : 1;

// With 16 registers a slot's sums fit by themselves only.
#undef SUM_SLOT_INLINE
#if FEW_REGISTERS
#define SUM_SLOT_INLINE HWY_NOINLINE
#else
#define SUM_SLOT_INLINE HWY_INLINE
#endif

template <int kRows, int kCount>
struct Sums {
  V32 even[kRows][kCount];
  V32 odd[kRows][kCount];
};

/// Nothing, but v is in a register here: left alone GCC 12 reorders until they do not suffice.
HWY_INLINE void HoldInRegister(V32& v) {
#if FEW_REGISTERS
  asm volatile("" : "+x"(v.raw));
#else
  (void)v;
#endif
}

/// Adds what one pair of taps gives.
template <bool kEven, int kRows, int kCount>
HWY_INLINE void AddTaps(const std::int32_t* HWY_RESTRICT from,
                        const std::int32_t* const (&even_taps)[kRows],
                        const std::int32_t* const (&odd_taps)[kRows], std::size_t k,
                        Sums<kRows, kCount>& s) {
  const D32 d;
  const int step = static_cast<int>(hn::Lanes(d));
  V32 even_tap[kRows], odd_tap[kRows];
#pragma GCC unroll 2
  for (int r = 0; r < kRows; ++r) {
    if constexpr (kEven) even_tap[r] = hn::Set(d, even_taps[r][k]);
    odd_tap[r] = hn::Set(d, odd_taps[r][k]);
  }
#pragma GCC unroll 5
  for (int v = 0; v < kCount; ++v) {
    V32 value = hn::LoadU(d, from + v * step);
    HoldInRegister(value);
#pragma GCC unroll 2
    for (int r = 0; r < kRows; ++r) {
      if constexpr (kEven) {
        s.even[r][v] = MultiplyAddPairs(s.even[r][v], value, even_tap[r]);
        HoldInRegister(s.even[r][v]);
      }
      s.odd[r][v] = MultiplyAddPairs(s.odd[r][v], value, odd_tap[r]);
      HoldInRegister(s.odd[r][v]);
    }
  }
}

/// Adds what the products of one slot give from x on.
template <bool kEven, int kRows, int kCount>
SUM_SLOT_INLINE void SumSlot(const ColumnJob& job, std::size_t slot, std::size_t first, int x,
                             Sums<kRows, kCount>& sums) {
  const std::size_t taps = job.offsets.size();
  const std::ptrdiff_t* HWY_RESTRICT offsets = job.offsets.data();
  Sums<kRows, kCount> s = sums;
  for (const ColumnInput& input : job.slots[slot]) {
    const std::int32_t* even_taps[kRows];
    const std::int32_t* odd_taps[kRows];
    for (int r = 0; r < kRows; ++r) {
      even_taps[r] = input.even_taps[first + static_cast<std::size_t>(r)];
      odd_taps[r] = input.odd_taps[first + static_cast<std::size_t>(r)];
    }
    auto from = [&](std::size_t k) { return input.rows + offsets[k] + x; };
    std::size_t k = 0;
    if constexpr (kTapsAtOnce == 2) {
      for (; k + 1 < taps; k += 2) {
        AddTaps<kEven>(from(k), even_taps, odd_taps, k, s);
        AddTaps<kEven>(from(k + 1), even_taps, odd_taps, k + 1, s);
      }
    }
    for (; k < taps; ++k) AddTaps<kEven>(from(k), even_taps, odd_taps, k, s);
  }
  sums = s;
}

/// Whole grey levels of a sum over the support.
HWY_INLINE V32 WholeBox(const std::int32_t* box) {
  const D32 d;
  const V32 half = hn::Set(d, 1 << (FilterBank::kGreyShift - 1));
  return hn::ShiftRight<FilterBank::kGreyShift>(hn::Add(hn::LoadU(d, box), half));
}

/// kCount vectors of kRows output rows, from row `first` and x on.
template <int kRows, int kCount>
HWY_INLINE void FilterBlock(const ColumnJob& job, std::size_t first, int x) {
  const D32 d;
  const int step = static_cast<int>(hn::Lanes(d));
  const V32 half = hn::Set(d, 1 << (FilterBank::kColumnShift - 1));
  const V32 offset = hn::Set(d, job.offset + (1 << (FilterBank::kColumnShift - 1)));
  const V32 box_factor = hn::Set(d, job.box_factor);
  Sums<kRows, kCount> slot0, slot1;
#pragma GCC unroll 2
  for (int r = 0; r < kRows; ++r) {
    const std::int32_t* box = job.box[first + static_cast<std::size_t>(r)];
#pragma GCC unroll 5
    for (int v = 0; v < kCount; ++v) {
      // The mean is the same at theta and pi - theta: it belongs to slot 0.
      slot0.even[r][v] = offset;
      if (box != nullptr) {
        slot0.even[r][v] = hn::Sub(offset, hn::Mul(WholeBox(box + x + v * step), box_factor));
      }
      slot0.odd[r][v] = half;
      slot1.even[r][v] = slot1.odd[r][v] = hn::Zero(d);
    }
  }
  SumSlot<true>(job, 0, first, x, slot0);
  SumSlot<true>(job, 1, first, x, slot1);
#pragma GCC unroll 2
  for (int r = 0; r < kRows; ++r) {
    const std::size_t row = first + static_cast<std::size_t>(r);
#pragma GCC unroll 5
    for (int v = 0; v < kCount; ++v) {
      const int at = x + v * step;
      Finish(hn::Add(slot0.even[r][v], slot1.even[r][v]), hn::Add(slot0.odd[r][v], slot1.odd[r][v]),
             at, job.direct[row]);
      if (job.mirrored[row].code == nullptr && job.mirrored[row].odd == nullptr) continue;
      Finish(hn::Sub(slot0.even[r][v], slot1.even[r][v]), hn::Sub(slot0.odd[r][v], slot1.odd[r][v]),
             at, job.mirrored[row]);
    }
  }
}

/// The same for odd cells only. The sums' `even` are never used.
template <int kRows, int kCount>
HWY_INLINE void FilterOddBlock(const ColumnJob& job, std::size_t first, int x) {
  const D32 d;
  const int step = static_cast<int>(hn::Lanes(d));
  const V32 half = hn::Set(d, 1 << (FilterBank::kColumnShift - 1));
  Sums<kRows, kCount> slot0, slot1;
#pragma GCC unroll 2
  for (int r = 0; r < kRows; ++r) {
#pragma GCC unroll 5
    for (int v = 0; v < kCount; ++v) {
      slot0.even[r][v] = slot1.even[r][v] = slot1.odd[r][v] = hn::Zero(d);
      slot0.odd[r][v] = half;
    }
  }
  SumSlot<false>(job, 0, first, x, slot0);
  SumSlot<false>(job, 1, first, x, slot1);
#pragma GCC unroll 2
  for (int r = 0; r < kRows; ++r) {
    const std::size_t row = first + static_cast<std::size_t>(r);
#pragma GCC unroll 5
    for (int v = 0; v < kCount; ++v) {
      const int at = x + v * step;
      FinishOdd(hn::Add(slot0.odd[r][v], slot1.odd[r][v]), at, job.direct[row]);
      if (job.mirrored[row].odd == nullptr) continue;
      FinishOdd(hn::Sub(slot0.odd[r][v], slot1.odd[r][v]), at, job.mirrored[row]);
    }
  }
}

template <bool kEven, int kRows, int kCount>
HWY_INLINE void FilterOneBlock(const ColumnJob& job, std::size_t first, int x) {
  if constexpr (kEven) {
    FilterBlock<kRows, kCount>(job, first, x);
  } else {
    FilterOddBlock<kRows, kCount>(job, first, x);
  }
}

template <bool kEven, int kRows>
HWY_INLINE void FilterBlocks(const ColumnJob& job, std::size_t first, int width) {
  const int step = static_cast<int>(hn::Lanes(D32()));
  int x = 0;
  for (; x + (kVectors - 1) * step < width; x += kVectors * step) {
    FilterOneBlock<kEven, kRows, kVectors>(job, first, x);
  }
  for (; x + step < width; x += 2 * step) FilterOneBlock<kEven, kRows, 2>(job, first, x);
  for (; x < width; x += step) FilterOneBlock<kEven, kRows, 1>(job, first, x);
}

template <bool kEven>
HWY_INLINE void FilterAllRows(const ColumnJob& job, int width) {
  if (job.rows == kRowsInRegisters && kRowsInRegisters == 2) {
    FilterBlocks<kEven, 2>(job, 0, width);
    return;
  }
  for (int row = 0; row < job.rows; ++row) {
    FilterBlocks<kEven, 1>(job, static_cast<std::size_t>(row), width);
  }
}

void FilterColumns(const ColumnJob& job, int width) {
  if (job.odd_only) {
    FilterAllRows<false>(job, width);
  } else {
    FilterAllRows<true>(job, width);
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

HWY_EXPORT(FoldRow);
HWY_EXPORT(FilterRows);
HWY_EXPORT(FilterColumns);
HWY_EXPORT(SlideBox);

void fold_row(const std::int16_t* grey, int radius, int width, const FoldedRow& out) {
  HWY_DYNAMIC_DISPATCH(FoldRow)(grey, radius, width, out);
}

void filter_rows(const FoldedRow& a, const FoldedRow& b, const RowTaps& taps, int width,
                 std::int32_t* out) {
  HWY_DYNAMIC_DISPATCH(FilterRows)(a, b, taps, width, out);
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
