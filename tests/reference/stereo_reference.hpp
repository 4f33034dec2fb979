#pragma once

#include <algorithm>
#include <bitset>
#include <vector>

#include "striate/perception/descriptor/descriptor_points.hpp"
#include "tests/reference/v1_reference.hpp"

/// The paper's descriptor and stereo by the book.
namespace striate::reference {

using Bits = std::bitset<256>;

/// Dense descriptors, row by row: bit point * 8 + orientation = centre > point.
inline std::vector<Bits> describe(const V1Reference& v1, double wavelength_px,
                                  double widening = 1.0) {
  const auto points = perception::descriptor_points(wavelength_px, widening);
  const cv::Size size = v1.energy[0].size();
  std::vector<Bits> result(static_cast<std::size_t>(size.area()));
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      Bits& bits = result[static_cast<std::size_t>(y * size.width + x)];
      for (std::size_t p = 0; p < points.size(); ++p) {
        const int u = std::clamp(x + points[p].du, 0, size.width - 1);
        const int v = std::clamp(y + points[p].dv, 0, size.height - 1);
        for (std::size_t i = 0; i < 8; ++i) {
          bits[p * 8 + i] = v1.energy[i](y, x) > v1.energy[i](v, u);
        }
      }
    }
  }
  return result;
}

/// Smallest Hamming distance among candidates 0 .. count - 1 leftwards; ties: smallest disparity.
inline cv::Mat1b best_match(const std::vector<Bits>& left, const std::vector<Bits>& right,
                            cv::Size size, int count) {
  cv::Mat1b result(size);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const std::size_t at = static_cast<std::size_t>(y * size.width + x);
      std::size_t smallest = 1000;
      for (int d = 0; d < std::min(count, x + 1); ++d) {
        const std::size_t distance = (left[at] ^ right[at - static_cast<std::size_t>(d)]).count();
        if (distance < smallest) {
          smallest = distance;
          result(y, x) = static_cast<std::uint8_t>(d);
        }
      }
    }
  }
  return result;
}

/// Median of the 5x5 neighbourhood, border pixels repeated.
inline cv::Mat1b median5(const cv::Mat1b& from) {
  cv::Mat1b wide, result(from.size());
  cv::copyMakeBorder(from, wide, 2, 2, 2, 2, cv::BORDER_REPLICATE);
  for (int y = 0; y < from.rows; ++y) {
    for (int x = 0; x < from.cols; ++x) {
      std::array<std::uint8_t, 25> values{};
      for (int k = 0; k < 25; ++k) {
        values[static_cast<std::size_t>(k)] = wide(y + k / 5, x + k % 5);
      }
      std::ranges::nth_element(values, values.begin() + 12);
      result(y, x) = values[12];
    }
  }
  return result;
}

/// The paper's stereo to the letter, in double precision.
inline cv::Mat1b paper_stereo(const cv::Mat& left, const cv::Mat& right, int count,
                              const perception::V1Settings& settings = {}) {
  const auto left_bits = describe(respond(left, settings), settings.wavelength_px);
  const auto right_bits = describe(respond(right, settings), settings.wavelength_px);
  return median5(best_match(left_bits, right_bits, left.size(), count));
}

}  // namespace striate::reference
