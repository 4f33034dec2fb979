#define HWY_WANT_AVX3_DL 1

#include "striate/perception/descriptor/phase_code.hpp"

#include <algorithm>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "striate/perception/descriptor/phase_code.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace striate::perception::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// One image row: 8 rows of even and odd responses to 4 rows of bytes.
void PhaseRow(const std::int16_t* const* even_rows, const std::int16_t* const* odd_rows, int width,
              std::uint8_t* const* out) {
  const hn::ScalableTag<std::int16_t> d16;
  const hn::Rebind<std::uint8_t, decltype(d16)> d8;
  const int step = static_cast<int>(hn::Lanes(d16));
  const auto zero = hn::Zero(d16);
  for (int x = 0; x < width; x += step) {
    auto code0 = zero, code1 = zero, code2 = zero, code3 = zero;
    for (int i = 0; i < kOrientations; ++i) {
      const auto bit = hn::Set(d16, static_cast<std::int16_t>(1 << i));
      const auto even = hn::LoadU(d16, even_rows[i] + x);
      const auto odd = hn::LoadU(d16, odd_rows[i] + x);
      code0 = hn::Or(code0, hn::IfThenElseZero(hn::Gt(odd, zero), bit));
      code1 = hn::Or(code1, hn::IfThenElseZero(hn::Gt(even, zero), bit));
      code2 = hn::Or(code2, hn::IfThenElseZero(hn::Gt(even, odd), bit));
      code3 = hn::Or(code3, hn::IfThenElseZero(hn::Gt(hn::SaturatedAdd(even, odd), zero), bit));
    }
    hn::StoreU(hn::DemoteTo(d8, code0), d8, out[0] + x);
    hn::StoreU(hn::DemoteTo(d8, code1), d8, out[1] + x);
    hn::StoreU(hn::DemoteTo(d8, code2), d8, out[2] + x);
    hn::StoreU(hn::DemoteTo(d8, code3), d8, out[3] + x);
  }
}

}  // namespace striate::perception::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate::perception {
namespace {

void continue_beyond_border(Plane<std::uint8_t>& plane) {
  const int width = plane.width(), left = plane.margin();
  for (int y = 0; y < plane.height(); ++y) {
    std::uint8_t* row = plane.row(y);
    std::fill(row - left, row, row[0]);
    std::fill(row + width, row - left + plane.stride(), row[width - 1]);
  }
  const auto bytes = static_cast<std::size_t>(plane.stride());
  for (int y = 1; y <= plane.margin_rows(); ++y) {
    std::memcpy(plane.row(-y) - left, plane.row(0) - left, bytes);
    const int last = plane.height() - 1;
    std::memcpy(plane.row(last + y) - left, plane.row(last) - left, bytes);
  }
}

}  // namespace

HWY_EXPORT(PhaseRow);

void phase_codes(const V1Responses& responses, int margin, PhaseCodes& out) {
  out.width = responses.width;
  out.height = responses.height;
  for (Plane<std::uint8_t>& plane : out.bytes) {
    plane.resize(responses.width, responses.height, margin + kPhaseReach, kPhaseReach);
  }
  for (int y = 0; y < responses.height; ++y) {
    std::array<const std::int16_t*, kOrientations> even{}, odd{};
    for (std::size_t i = 0; i < kOrientations; ++i) {
      even[i] = responses.even[i].row(y);
      odd[i] = responses.odd[i].row(y);
    }
    std::array<std::uint8_t*, kPhaseBytes> to{};
    for (std::size_t k = 0; k < kPhaseBytes; ++k) to[k] = out.bytes[k].row(y);
    HWY_DYNAMIC_DISPATCH(PhaseRow)(even.data(), odd.data(), responses.width, to.data());
  }
  for (Plane<std::uint8_t>& plane : out.bytes) continue_beyond_border(plane);
}

}  // namespace striate::perception
#endif
