#pragma once

#include <cstdint>

#include "perception/descriptor/dense_descriptor.hpp"

/// Hamming costs of one picture row; vector code, dispatched at run time, integer.
namespace striate::stereo_kernels {

/// costs[d * cost_stride + x] = bits in which left pixel x and right pixel x - d differ, at most
/// 255; 255 where x - d lies outside the picture.
/// @param right readable from `candidates` + 3 bytes before column 0.
/// @param outside outside[x] is 255 for x < 0 and 0 otherwise, for x >= -(candidates + 3).
/// @param candidates rounded up to a multiple of 4: so many rows of costs are written.
void hamming_costs(const DescriptorRow& left, const DescriptorRow& right,
                   const std::uint8_t* outside, int width, int candidates, std::uint8_t* costs,
                   int cost_stride);

/// best[x] = the disparity of the smallest cost; of equal ones the smallest disparity.
void smallest_cost(const std::uint8_t* costs, int cost_stride, int width, int candidates,
                   std::uint8_t* best);

}  // namespace striate::stereo_kernels
