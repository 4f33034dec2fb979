#pragma once

#include <array>
#include <cstdint>

#include "striate/perception/descriptor/descriptor_points.hpp"
#include "striate/perception/percept.hpp"
#include "striate/perception/v1/v1_cells.hpp"

namespace striate::perception {

/// Descriptors of one image row as 32 byte planes: byte p of pixel x is at
/// `data[p * stride + x]`; its bit i is set where C_i at the centre is larger than C_i at point p.
struct DescriptorRow {
  std::uint8_t* data = nullptr;
  int stride = 0;  ///< bytes; at least the width rounded up to 64
};

/// Writes the descriptors of row y (the paper's section on descriptors). Vectorised; integer, so
/// the same on every instruction set. `responses.margin()` must cover the points.
void describe_row(const V1Responses& responses,
                  const std::array<DescriptorPoint, kDescriptorPoints>& points, int y,
                  const DescriptorRow& row);

/// The descriptor of one pixel; bit p * 8 + i is point p, orientation i.
[[nodiscard]] Descriptor describe_pixel(
    const V1Responses& responses, const std::array<DescriptorPoint, kDescriptorPoints>& points,
    int u, int v);

/// Number of bits in which two descriptors differ, 0..256.
[[nodiscard]] int hamming_distance(const Descriptor& a, const Descriptor& b);

}  // namespace striate::perception
