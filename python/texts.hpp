#pragma once

#include <pybind11/pybind11.h>

#include <string_view>

namespace striate::python {

/// A text for Python. Names of files may be of any bytes, and a reason in fixed memory may be cut
/// within a letter: what is no UTF-8 is replaced.
[[nodiscard]] inline pybind11::object text_of(std::string_view text) {
  return pybind11::reinterpret_steal<pybind11::object>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
}

}  // namespace striate::python
