#pragma once

#include <pybind11/numpy.h>

#include "striate/perception/matching/hamming_search.hpp"
#include "striate/perception/percept.hpp"
#include "striate/platform/interface/senses.hpp"

namespace striate::python {

/// Tells numpy the fields of the structs that are handed out as structured arrays, once.
void describe_records();

}  // namespace striate::python
