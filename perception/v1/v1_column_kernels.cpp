#define HWY_WANT_AVX3_DL 1

#include "striate/perception/v1/v1_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "striate/perception/v1/v1_column_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include "striate/perception/v1/v1_vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace striate::perception::v1_kernels::HWY_NAMESPACE {

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

/// Writes what is wanted of the responses from x on.
template <bool kEven>
HWY_INLINE void Finish(V32 even_sum, V32 odd_sum, int x, const Responses& to) {
  const hn::Rebind<std::int16_t, D32> d16;
  const V32 odd = hn::ShiftRight<FilterBank::kColumnShift>(odd_sum);
  if constexpr (kEven) {
    const V32 even = hn::ShiftRight<FilterBank::kColumnShift>(even_sum);
    if (to.code != nullptr) hn::StoreU(hn::DemoteTo(d16, EnergyCode(even, odd)), d16, to.code + x);
    if (to.even != nullptr) hn::StoreU(hn::DemoteTo(d16, even), d16, to.even + x);
  }
  if (to.odd != nullptr) hn::StoreU(hn::DemoteTo(d16, odd), d16, to.odd + x);
}

#undef FEW_REGISTERS
#if HWY_TARGET == HWY_AVX2 || HWY_TARGET == HWY_SSE4 || HWY_TARGET == HWY_SSSE3
#define FEW_REGISTERS 1
#else
#define FEW_REGISTERS 0
#endif

// What is summed up at a time, rows x vectors, even and odd, fits into 32 or 16 registers.
constexpr int kVectors = 4;
/// Rows: 2 x 4 vectors, even and odd, are 16 of 32 registers
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

/// What the even sums begin with: the rounding, less the mean under the filter.
HWY_INLINE V32 EvenStart(const ColumnJob& job, std::size_t row, int x) {
  const D32 d;
  const V32 offset = hn::Set(d, job.offset + (1 << (FilterBank::kColumnShift - 1)));
  const std::int32_t* box = job.box[row];
  if (box == nullptr) return offset;
  return hn::Sub(offset, hn::Mul(WholeBox(box + x), hn::Set(d, job.box_factor)));
}

/// kCount vectors of kRows output rows, from row `first` and x on; even and odd cells or, with
/// kEven false, odd ones only: the sums' `even` are then never used.
template <bool kEven, int kRows, int kCount>
HWY_INLINE void FilterBlock(const ColumnJob& job, std::size_t first, int x) {
  const D32 d;
  const int step = static_cast<int>(hn::Lanes(d));
  const V32 half = hn::Set(d, 1 << (FilterBank::kColumnShift - 1));
  Sums<kRows, kCount> slot0, slot1;
#pragma GCC unroll 2
  for (int r = 0; r < kRows; ++r) {
    const std::size_t row = first + static_cast<std::size_t>(r);
#pragma GCC unroll 5
    for (int v = 0; v < kCount; ++v) {
      // The mean is the same at theta and pi - theta: it belongs to slot 0.
      slot0.even[r][v] = kEven ? EvenStart(job, row, x + v * step) : hn::Zero(d);
      slot0.odd[r][v] = half;
      slot1.even[r][v] = slot1.odd[r][v] = hn::Zero(d);
    }
  }
  SumSlot<kEven>(job, 0, first, x, slot0);
  SumSlot<kEven>(job, 1, first, x, slot1);
#pragma GCC unroll 2
  for (int r = 0; r < kRows; ++r) {
    const std::size_t row = first + static_cast<std::size_t>(r);
    const Responses& mirrored = job.mirrored[row];
#pragma GCC unroll 5
    for (int v = 0; v < kCount; ++v) {
      const int at = x + v * step;
      Finish<kEven>(hn::Add(slot0.even[r][v], slot1.even[r][v]),
                    hn::Add(slot0.odd[r][v], slot1.odd[r][v]), at, job.direct[row]);
      if (mirrored.code == nullptr && mirrored.odd == nullptr) continue;
      Finish<kEven>(hn::Sub(slot0.even[r][v], slot1.even[r][v]),
                    hn::Sub(slot0.odd[r][v], slot1.odd[r][v]), at, mirrored);
    }
  }
}

template <bool kEven, int kRows>
HWY_INLINE void FilterBlocks(const ColumnJob& job, std::size_t first, int width) {
  const int step = static_cast<int>(hn::Lanes(D32()));
  int x = 0;
  for (; x + (kVectors - 1) * step < width; x += kVectors * step) {
    FilterBlock<kEven, kRows, kVectors>(job, first, x);
  }
  for (; x + step < width; x += 2 * step) FilterBlock<kEven, kRows, 2>(job, first, x);
  for (; x < width; x += step) FilterBlock<kEven, kRows, 1>(job, first, x);
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

}  // namespace striate::perception::v1_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate::perception::v1_kernels {

HWY_EXPORT(FilterColumns);

void filter_columns(const ColumnJob& job, int width) {
  HWY_DYNAMIC_DISPATCH(FilterColumns)(job, width);
}

}  // namespace striate::perception::v1_kernels
#endif
