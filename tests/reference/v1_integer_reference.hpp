#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <opencv2/core.hpp>

#include "striate/perception/v1/filter_bank.hpp"

/// The integer algorithm of FilterBank written down plainly: every vector path must give exactly
/// these numbers.
namespace striate::reference {

struct V1Integers {
  std::array<cv::Mat1s, 8> even, odd, code;
};

namespace detail {

/// 16 (grey - 128); `grey` counts sixteenths if it has 16 bits.
inline int grey_at(const cv::Mat& grey, int y, int x) {
  const int v = cv::borderInterpolate(y, grey.rows, cv::BORDER_REFLECT_101);
  const int u = cv::borderInterpolate(x, grey.cols, cv::BORDER_REFLECT_101);
  const int value =
      grey.depth() == CV_8U ? 16 * grey.at<std::uint8_t>(v, u) : grey.at<std::uint16_t>(v, u);
  return value - 16 * 128;
}

inline std::int64_t row_result(const cv::Mat& grey, const std::vector<std::int16_t>& taps, int y,
                               int x) {
  const int radius = static_cast<int>(taps.size()) / 2;
  std::int64_t sum = 1 << (perception::FilterBank::kRowShift - 1);
  for (int k = -radius; k <= radius; ++k) {
    sum += taps[static_cast<std::size_t>(k + radius)] * grey_at(grey, y, x + k);
  }
  return sum >> perception::FilterBank::kRowShift;
}

inline std::int64_t box_sum(const cv::Mat& grey, int radius, int y, int x) {
  std::int64_t sum = 0;
  for (int v = -radius; v <= radius; ++v) {
    for (int u = -radius; u <= radius; ++u) sum += grey_at(grey, y + v, x + u);
  }
  return (sum + 8) >> 4;
}

inline std::int16_t energy_code(std::int64_t even, std::int64_t odd) {
  const auto energy = static_cast<std::int32_t>(even * even + odd * odd + 1);
  const auto bits = std::bit_cast<std::int32_t>(static_cast<float>(energy));
  return static_cast<std::int16_t>((bits >> 12) - (127 << 11) - 32768);
}

}  // namespace detail

inline V1Integers integer_responses(const cv::Mat& grey, const perception::FilterBank& bank) {
  V1Integers result;
  for (auto* group : {&result.even, &result.odd, &result.code}) {
    for (cv::Mat1s& plane : *group) plane.create(grey.size());
  }
  const int radius = bank.radius;
  for (const perception::FilterBank::Pair& pair : bank.pairs) {
    for (int y = 0; y < grey.rows; ++y) {
      for (int x = 0; x < grey.cols; ++x) {
        std::array<std::int64_t, 2> even{}, odd{};
        for (const perception::FilterBank::Product& p : pair.products) {
          for (int k = -radius; k <= radius; ++k) {
            const auto tap = static_cast<std::size_t>(k + radius);
            const std::int64_t row = detail::row_result(grey, p.row, y + k, x);
            even[static_cast<std::size_t>(p.slot)] += row * p.column_even[tap];
            odd[static_cast<std::size_t>(p.slot)] += row * p.column_odd[tap];
          }
        }
        const std::int64_t half = 1 << (perception::FilterBank::kColumnShift - 1);
        even[0] += pair.offset + half;
        if (pair.box_factor != 0) {
          even[0] -= pair.box_factor * detail::box_sum(grey, bank.box_radius, y, x);
        }
        odd[0] += half;
        auto store = [&](int orientation, std::int64_t even_sum, std::int64_t odd_sum) {
          if (orientation < 0) return;
          const auto i = static_cast<std::size_t>(orientation);
          const std::int64_t e = even_sum >> perception::FilterBank::kColumnShift;
          const std::int64_t o = odd_sum >> perception::FilterBank::kColumnShift;
          result.even[i](y, x) = static_cast<std::int16_t>(e);
          result.odd[i](y, x) = static_cast<std::int16_t>(o);
          result.code[i](y, x) = detail::energy_code(e, o);
        };
        store(pair.orientation, even[0] + even[1], odd[0] + odd[1]);
        store(pair.mirrored, even[0] - even[1], odd[0] - odd[1]);
      }
    }
  }
  return result;
}

}  // namespace striate::reference
