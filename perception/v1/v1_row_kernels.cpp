#define HWY_WANT_AVX3_DL 1

#include "striate/perception/v1/v1_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "striate/perception/v1/v1_row_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include "striate/perception/v1/v1_vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace striate::perception::v1_kernels::HWY_NAMESPACE {

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
    constexpr int kShift = FilterBank::kRowShift;  // what the row pass divides by
    hn::StoreU(JoinHalves(hn::ShiftRight<kShift>(a0), hn::ShiftRight<kShift>(b0)), d, out + x);
    hn::StoreU(JoinHalves(hn::ShiftRight<kShift>(a1), hn::ShiftRight<kShift>(b1)), d,
               out + x + step);
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

}  // namespace striate::perception::v1_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate::perception::v1_kernels {

HWY_EXPORT(FoldRow);
HWY_EXPORT(FilterRows);
HWY_EXPORT(SlideBox);

void fold_row(const std::int16_t* grey, int radius, int width, const FoldedRow& out) {
  HWY_DYNAMIC_DISPATCH(FoldRow)(grey, radius, width, out);
}

void filter_rows(const FoldedRow& a, const FoldedRow& b, const RowTaps& taps, int width,
                 std::int32_t* out) {
  HWY_DYNAMIC_DISPATCH(FilterRows)(a, b, taps, width, out);
}

void slide_box(const std::int32_t* add, const std::int32_t* subtract, int width,
               std::int32_t* box) {
  HWY_DYNAMIC_DISPATCH(SlideBox)(add, subtract, width, box);
}

}  // namespace striate::perception::v1_kernels
#endif
