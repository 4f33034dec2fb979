#pragma once

#include <pybind11/pybind11.h>

namespace striate::python {

/// As Python's `if` sees it: numpy.bool_ is no bool, but true or false.
/// @throws py::error_already_set for what is neither, such as an array of many
[[nodiscard]] inline bool is_true(const pybind11::object& value) {
  const int truth = PyObject_IsTrue(value.ptr());
  if (truth < 0) throw pybind11::error_already_set();
  return truth == 1;
}

}  // namespace striate::python
