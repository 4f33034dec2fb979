#pragma once

#include <pybind11/numpy.h>

#include "striate/python/lent_memory.hpp"

/// Parts of short-term memory as Python's arrays.
namespace striate::python {

namespace py = pybind11;

/// Rows are sectors, columns rings.
[[nodiscard]] py::dict polar_of(const LentMemory& lent);
/// The grid's window: row 0 has the least y, column 0 the least x.
[[nodiscard]] py::array grid_of(const LentMemory& lent);
/// (n, 2): x and y, the start first.
[[nodiscard]] py::array trajectory_of(const LentMemory& lent);

}  // namespace striate::python
