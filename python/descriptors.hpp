#pragma once

#include <vector>

#include "striate/perception/percept.hpp"
#include "striate/python/arrays.hpp"

namespace striate::python {

/// The descriptors of keypoints where they lie: (n, 32) uint8, bit b in byte b / 8.
[[nodiscard]] py::array descriptors_view(const std::vector<perception::Keypoint>& keypoints,
                                         const Owner& owner);

/// An array (n, 32) of uint8 as descriptors. @param name of the argument, for messages
/// @throws py::type_error, UserError for what is none
[[nodiscard]] std::vector<perception::Descriptor> descriptors_of(const py::handle& given,
                                                                 const char* name);

}  // namespace striate::python
