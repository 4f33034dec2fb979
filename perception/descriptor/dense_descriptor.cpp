#define HWY_WANT_AVX3_DL 1

#include "perception/descriptor/dense_descriptor.hpp"

#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "perception/descriptor/dense_descriptor.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace striate::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// 16-bit values below 256 as bytes.
template <class D16, class V16>
HWY_INLINE void StoreBytes(D16 d16, V16 low, V16 high, std::uint8_t* out) {
#if HWY_TARGET == HWY_SCALAR
  out[0] = static_cast<std::uint8_t>(hn::GetLane(low));
  out[hn::Lanes(d16)] = static_cast<std::uint8_t>(hn::GetLane(high));
#else
  const hn::Repartition<std::uint8_t, D16> d8;
  hn::StoreU(hn::ConcatEven(d8, hn::BitCast(d8, high), hn::BitCast(d8, low)), d8, out);
#endif
}

/// 8 comparisons of one point for 2 * lanes pixels. Rows of the 8 code planes at the centre;
/// `shift` elements further lies the point.
void ComparePoint(const std::int16_t* const* centre_rows, const std::int16_t* const* point_rows,
                  int du, int width, std::uint8_t* HWY_RESTRICT out) {
  const hn::ScalableTag<std::int16_t> d16;
  const int step = static_cast<int>(hn::Lanes(d16));
  for (int x = 0; x < width; x += 2 * step) {
    auto low = hn::Zero(d16);
    auto high = hn::Zero(d16);
    for (int i = 0; i < kOrientations; ++i) {
      const auto bit = hn::Set(d16, static_cast<std::int16_t>(1 << i));
      const std::int16_t* centre = centre_rows[i] + x;
      const std::int16_t* point = point_rows[i] + x + du;
      low = hn::Or(low,
                   hn::IfThenElseZero(hn::Gt(hn::LoadU(d16, centre), hn::LoadU(d16, point)), bit));
      high = hn::Or(high,
                    hn::IfThenElseZero(
                        hn::Gt(hn::LoadU(d16, centre + step), hn::LoadU(d16, point + step)), bit));
    }
    StoreBytes(d16, low, high, out + x);
  }
}

}  // namespace striate::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate {

HWY_EXPORT(ComparePoint);

void describe_row(const V1Responses& responses,
                  const std::array<DescriptorPoint, kDescriptorPoints>& points, int y,
                  const DescriptorRow& row) {
  std::array<const std::int16_t*, kOrientations> centre{};
  for (std::size_t i = 0; i < kOrientations; ++i) centre[i] = responses.code[i].row(y);
  std::uint8_t* out = row.data;
  for (const DescriptorPoint& point : points) {
    std::array<const std::int16_t*, kOrientations> other{};
    for (std::size_t i = 0; i < kOrientations; ++i) {
      other[i] = responses.code[i].row(y + point.dv);
    }
    HWY_DYNAMIC_DISPATCH(ComparePoint)
    (centre.data(), other.data(), point.du, responses.width, out);
    out += row.stride;
  }
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

}  // namespace striate
#endif
