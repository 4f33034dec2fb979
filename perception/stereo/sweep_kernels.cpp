#define HWY_WANT_AVX3_DL 1

#include "striate/perception/stereo/sweep_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "striate/perception/stereo/sweep_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h, which defines the target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace striate::perception::stereo_kernels::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using D8 = hn::ScalableTag<std::uint8_t>;

/// The window of three disparities that slides over one path direction at one position.
template <class D>
struct Path {
  using V = hn::Vec<D>;
  const std::uint8_t* HWY_RESTRICT from;  ///< of the line before, already askew
  std::uint8_t* HWY_RESTRICT to;
  V below, at, floor, ceiling, smallest;

  HWY_INLINE void Start(const PathLine& before, const PathLine& here, int x, int askew,
                        V large_penalty) {
    const D d8;
    from = before.costs + x + askew;
    to = here.costs + x;
    floor = hn::LoadU(d8, before.smallest + x + askew);
    ceiling = hn::SaturatedAdd(floor, large_penalty);
    below = hn::Set(d8, 255);
    at = hn::LoadU(d8, from);
    smallest = hn::Set(d8, 255);
  }

  /// Path cost of the next disparity; `above` is the one after it in the line before.
  HWY_INLINE V Next(V cost, V above, V small_penalty) {
    const V step = hn::SaturatedAdd(hn::Min(below, above), small_penalty);
    const V best = hn::Min(hn::Min(at, step), ceiling);
    const V result = hn::SaturatedAdd(cost, hn::Sub(best, floor));
    smallest = hn::Min(smallest, result);
    below = at;
    at = above;
    return result;
  }
};

/// One half of the lanes of three results, as 16 bit, onto the sums.
template <class D16, class V, class Half>
HWY_INLINE void AddHalf(D16 d16, const V* results, Half half, const std::uint16_t* others,
                        std::uint16_t* sums) {
  const auto two =
      hn::Add(hn::PromoteTo(d16, half(results[0])), hn::PromoteTo(d16, half(results[1])));
  const auto three = hn::Add(two, hn::PromoteTo(d16, half(results[2])));
  hn::StoreU(others == nullptr ? three : hn::Add(three, hn::LoadU(d16, others)), d16, sums);
}

template <class D, class V = hn::Vec<D>>
HWY_INLINE void AddToSums(D /*d8*/, const V* results, const std::uint16_t* others,
                          std::uint16_t* sums) {
#if HWY_TARGET == HWY_SCALAR
  const hn::Rebind<std::uint16_t, D> d16;
  AddHalf(
      d16, results, [](V v) HWY_ATTR { return v; }, others, sums);
#else
  const hn::Repartition<std::uint16_t, D> d16;
  const hn::Half<D> half8;
  const int half = static_cast<int>(hn::Lanes(d16));
  AddHalf(
      d16, results, [=](V v) HWY_ATTR { return hn::LowerHalf(half8, v); }, others, sums);
  AddHalf(
      d16, results, [=](V v) HWY_ATTR { return hn::UpperHalf(half8, v); },
      others == nullptr ? nullptr : others + half, sums + half);
#endif
}

/// Behind the last position paths start anew.
void CloseLine(const SweepStep& s, const PathLine& here) {
  here.smallest[s.width] = 0;
  for (int d = 0; d < s.disparities; ++d) here.costs[d * s.stride + s.width] = 0;
}

/// The positions from x on, as many as a vector has lanes.
template <class D>
HWY_INLINE void SweepThreeAt(D d8, const SweepStep& s, const ThreePaths& p, int x) {
  using V = hn::Vec<D>;
  const V small_penalty = hn::Set(d8, static_cast<std::uint8_t>(s.small_penalty));
  const V large_penalty = hn::Set(d8, static_cast<std::uint8_t>(s.large_penalty));
  Path<D> paths[3];
  V results[3];
  HWY_UNROLL(3)
  for (int k = 0; k < 3; ++k) {
    const auto direction = static_cast<std::size_t>(k);
    paths[k].Start(p.before[direction], p.here[direction], x, k - 1, large_penalty);
  }
  // Copies: bytes that are stored could be anything, also the members of s and p.
  const int stride = s.stride, sum_stride = p.sum_stride, last = s.disparities - 1;
  const std::uint8_t* HWY_RESTRICT costs = s.costs + x;
  const std::uint16_t* others = p.others == nullptr ? nullptr : p.others + x;
  std::uint16_t* sums = p.sums + x;
  for (int d = 0; d <= last; ++d) {
    const V cost = hn::LoadU(d8, costs + d * stride);
    HWY_UNROLL(3)
    for (int k = 0; k < 3; ++k) {
      const V above =
          d == last ? hn::Set(d8, 255) : hn::LoadU(d8, paths[k].from + (d + 1) * stride);
      results[k] = paths[k].Next(cost, above, small_penalty);
      hn::StoreU(results[k], d8, paths[k].to + d * stride);
    }
    AddToSums(d8, results, others == nullptr ? nullptr : others + d * sum_stride,
              sums + d * sum_stride);
  }
  HWY_UNROLL(3)
  for (int k = 0; k < 3; ++k) {
    hn::StoreU(paths[k].smallest, d8, p.here[static_cast<std::size_t>(k)].smallest + x);
  }
}

void SweepThree(const SweepStep& s, const ThreePaths& p) {
  const D8 d8;
  const int step = static_cast<int>(hn::Lanes(d8));
  int x = 0;
#if HWY_TARGET == HWY_SCALAR
  for (; x < s.width; x += step) SweepThreeAt(d8, s, p, x);
#else
  for (; x + step / 2 < s.width; x += step) SweepThreeAt(d8, s, p, x);
  if (x < s.width) SweepThreeAt(hn::Half<D8>(), s, p, x);  // the rest fills half a vector at most
#endif
  for (const PathLine& here : p.here) CloseLine(s, here);
}

void SweepStraight(const SweepStep& s, const StraightPath& p) {
  // A strip of rows lies in the lanes: no more of them than it has rows.
  const hn::CappedTag<std::uint8_t, kStripRows> d8;
  using V = hn::Vec<decltype(d8)>;
  const V small_penalty = hn::Set(d8, static_cast<std::uint8_t>(s.small_penalty));
  const V large_penalty = hn::Set(d8, static_cast<std::uint8_t>(s.large_penalty));
  const int step = static_cast<int>(hn::Lanes(d8));
  const int stride = s.stride, last = s.disparities - 1;
  for (int x = 0; x < s.width; x += step) {
    Path<hn::CappedTag<std::uint8_t, kStripRows>> path;
    path.Start(p.before, p.here, x, 0, large_penalty);
    const std::uint8_t* HWY_RESTRICT costs = s.costs + x;
    std::uint8_t* HWY_RESTRICT average = p.average == nullptr ? nullptr : p.average + x;
    for (int d = 0; d <= last; ++d) {
      const V cost = hn::LoadU(d8, costs + d * stride);
      const V above = d == last ? hn::Set(d8, 255) : hn::LoadU(d8, path.from + (d + 1) * stride);
      const V result = path.Next(cost, above, small_penalty);
      hn::StoreU(result, d8, path.to + d * stride);
      if (average != nullptr) {
        const V mean = hn::AverageRound(result, hn::LoadU(d8, average + d * stride));
        hn::StoreU(mean, d8, average + d * stride);
      }
    }
    hn::StoreU(path.smallest, d8, p.here.smallest + x);
  }
}

#if HWY_TARGET != HWY_SCALAR
/// 16x16 bytes; writes the first `count` columns as rows.
HWY_INLINE void TurnBlock(const std::uint8_t* const* from, int count, std::uint8_t* HWY_RESTRICT to,
                          std::ptrdiff_t to_line) {
  const hn::CappedTag<std::uint8_t, 16> d8;
  hn::Vec<decltype(d8)> rows[16], shuffled[16];
  HWY_UNROLL(16)
  for (int k = 0; k < 16; ++k) rows[k] = hn::LoadU(d8, from[k]);
  // Four perfect shuffles transpose.
  HWY_UNROLL(4)
  for (int round = 0; round < 4; ++round) {
    HWY_UNROLL(8)
    for (int k = 0; k < 8; ++k) {
      shuffled[2 * k] = hn::InterleaveLower(d8, rows[k], rows[k + 8]);
      shuffled[2 * k + 1] = hn::InterleaveUpper(d8, rows[k], rows[k + 8]);
    }
    HWY_UNROLL(16)
    for (int k = 0; k < 16; ++k) rows[k] = shuffled[k];
  }
  for (int k = 0; k < count; ++k) hn::StoreU(rows[k], d8, to + k * to_line);
}
#endif

/// [row][disparity][column] to [column][disparity][row], or back, in blocks of 16x16.
void Turn(const std::uint8_t* HWY_RESTRICT from, std::ptrdiff_t from_line, int from_stride,
          std::uint8_t* HWY_RESTRICT to, std::ptrdiff_t to_line, int to_stride,
          const TurnShape& shape) {
#if HWY_TARGET == HWY_SCALAR
  for (int y = 0; y < shape.lines; ++y) {
    for (int d = 0; d < shape.disparities; ++d) {
      for (int x = 0; x < shape.width; ++x) {
        to[x * to_line + d * to_stride + y] = from[y * from_line + d * from_stride + x];
      }
    }
  }
#else
  // 64 lines at a time: whole cache lines are written, and what is read stays in the cache.
  for (int block = 0; block < shape.lines; block += 64) {
    for (int d = 0; d < shape.disparities; ++d) {
      for (int x = 0; x < shape.width; x += 16) {
        for (int y = block; y < HWY_MIN(block + 64, shape.lines); y += 16) {
          // Beyond the last line the last one is read again; what it gives is never used.
          const std::uint8_t* rows[16];
          HWY_UNROLL(16)
          for (int k = 0; k < 16; ++k) {
            rows[k] = from + HWY_MIN(y + k, shape.lines - 1) * from_line + d * from_stride + x;
          }
          TurnBlock(rows, HWY_MIN(16, shape.width - x), to + x * to_line + d * to_stride + y,
                    to_line);
        }
      }
    }
  }
#endif
}

}  // namespace striate::perception::stereo_kernels::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace striate::perception::stereo_kernels {

HWY_EXPORT(SweepThree);
HWY_EXPORT(SweepStraight);
HWY_EXPORT(Turn);

void sweep_three(const SweepStep& step, const ThreePaths& paths) {
  HWY_DYNAMIC_DISPATCH(SweepThree)(step, paths);
}

void sweep_straight(const SweepStep& step, const StraightPath& path) {
  HWY_DYNAMIC_DISPATCH(SweepStraight)(step, path);
}

void turn(const VolumePart<const std::uint8_t>& from, const TurnShape& shape,
          const VolumePart<std::uint8_t>& to) {
  HWY_DYNAMIC_DISPATCH(Turn)
  (from.first, from.line, from.stride, to.first, to.line, to.stride, shape);
}

}  // namespace striate::perception::stereo_kernels
#endif
