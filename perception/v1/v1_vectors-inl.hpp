// Vector code, included once for every instruction set.
#if defined(STRIATE_V1_VECTORS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef STRIATE_V1_VECTORS_INL
#undef STRIATE_V1_VECTORS_INL
#else
#define STRIATE_V1_VECTORS_INL
#endif

#include <hwy/highway.h>

#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace striate::perception::v1_kernels::HWY_NAMESPACE {
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

}  // namespace striate::perception::v1_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
