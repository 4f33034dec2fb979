#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace striate {

/// The middle one; of an even number the larger of the two; 0 where there is none.
[[nodiscard]] inline double median_of(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace striate
