#define HWY_WANT_AVX3_DL 1

#include "striate/perception/descriptor/dense_descriptor.hpp"

#include <bit>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "striate/perception/descriptor/dense_descriptor.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace striate::perception::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Where the points lie in the planes of codes, as offsets from the centre.
using Offsets = std::array<std::ptrdiff_t, kDescriptorPoints>;

/// Sets bit i of `bits` where centre > point; called for i = 7 down to 0.
template <class D, class V>
HWY_INLINE V AppendBit(D d, V bits, int i, V centre, V point) {
#if HWY_TARGET <= HWY_AVX3 && HWY_TARGET != HWY_SCALAR
  // One masked addition.
  const V bit = hn::Set(d, static_cast<std::int16_t>(1 << i));
  return hn::IfThenElse(hn::Gt(centre, point), hn::Add(bits, bit), bits);
#else
  // True is -1.
  (void)i;
  return hn::Sub(hn::Add(bits, bits), hn::VecFromMask(d, hn::Gt(centre, point)));
#endif
}

/// Descriptors of one row: byte planes `stride` apart. The 8 codes of the centre stay in registers.
void DescribeRow(const std::int16_t* const* centre_rows, const Offsets& offsets, int width,
                 std::uint8_t* HWY_RESTRICT out, int stride) {
  const hn::ScalableTag<std::int16_t> d16;
  const hn::Rebind<std::uint8_t, decltype(d16)> d8;
  using V = hn::Vec<decltype(d16)>;
  const int step = static_cast<int>(hn::Lanes(d16));
  for (int x = 0; x < width; x += step) {
    const std::int16_t* from[kOrientations];
    V centre[kOrientations];
#pragma GCC unroll 8
    for (int i = 0; i < kOrientations; ++i) {
      from[i] = centre_rows[i] + x;
      centre[i] = hn::LoadU(d16, from[i]);
    }
    for (int p = 0; p < kDescriptorPoints; ++p) {
      const std::ptrdiff_t offset = offsets[static_cast<std::size_t>(p)];
      V bits = hn::Zero(d16);
#pragma GCC unroll 8
      for (int i = kOrientations - 1; i >= 0; --i) {
        bits = AppendBit(d16, bits, i, centre[i], hn::LoadU(d16, from[i] + offset));
      }
      hn::StoreU(hn::DemoteTo(d8, bits), d8, out + p * stride + x);
    }
  }
}

}  // namespace striate::perception::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate::perception {

HWY_EXPORT(DescribeRow);

void describe_row(const V1Responses& responses,
                  const std::array<DescriptorPoint, kDescriptorPoints>& points, int y,
                  const DescriptorRow& row) {
  std::array<const std::int16_t*, kOrientations> centre{};
  for (std::size_t i = 0; i < kOrientations; ++i) centre[i] = responses.code[i].row(y);
  // The planes of all orientations are of one shape.
  std::array<std::ptrdiff_t, kDescriptorPoints> offsets{};
  for (std::size_t p = 0; p < points.size(); ++p) {
    offsets[p] =
        static_cast<std::ptrdiff_t>(points[p].dv) * responses.code[0].stride() + points[p].du;
  }
  HWY_DYNAMIC_DISPATCH(DescribeRow)
  (centre.data(), offsets, responses.width, row.data, row.stride);
}

Descriptor describe_pixel(const V1Responses& responses,
                          const std::array<DescriptorPoint, kDescriptorPoints>& points, int u,
                          int v) {
  Descriptor descriptor;
  std::size_t bit = 0;
  for (const DescriptorPoint& point : points) {
    for (std::size_t i = 0; i < kOrientations; ++i, ++bit) {
      const Plane<std::int16_t>& plane = responses.code[i];
      const bool larger = plane.row(v)[u] > plane.row(v + point.dv)[u + point.du];
      descriptor.words[bit / 64] |= std::uint64_t{larger} << (bit % 64);
    }
  }
  return descriptor;
}

int hamming_distance(const Descriptor& a, const Descriptor& b) {
  int distance = 0;
  for (std::size_t k = 0; k < a.words.size(); ++k) {
    distance += std::popcount(a.words[k] ^ b.words[k]);
  }
  return distance;
}

}  // namespace striate::perception
#endif
