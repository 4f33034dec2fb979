#pragma once

#include <pybind11/pybind11.h>

#include <nlohmann/json.hpp>

namespace striate::python {

/// JSON as Python's own dicts, lists, texts and numbers; what is not UTF-8 is replaced.
[[nodiscard]] pybind11::object object_of(const nlohmann::ordered_json& json);

}  // namespace striate::python
