#pragma once

#include <pybind11/pybind11.h>

/// The parts of the module `striate._striate`, a file each. What people import is the package
/// `striate/` beside them, which adds what is easier said in Python.
namespace striate::python {

namespace py = pybind11;

void bind_errors(py::module_& module);
void bind_geometry(py::module_& module);
void bind_percept(py::module_& module);
void bind_perceiver(py::module_& module);
void bind_features(py::module_& module);
void bind_senses(py::module_& module);
void bind_long_term_memory(py::module_& module);
void bind_recording(py::module_& module);
void bind_simulator(py::module_& module);
void bind_short_term_memory(py::module_& module);
void bind_additions(py::module_& module);
void bind_mission(py::module_& module);

}  // namespace striate::python
