#pragma once

#include <pybind11/pybind11.h>

#include <exception>
#include <stdexcept>
#include <string>

/// What goes wrong in a person's Python while a mission runs. Between that code and whoever called
/// the mission lies C++, which ends the mission for any exception and stops the wheels, but keeps
/// only its words. So the exception itself is noted here, with its traceback, and raised at the
/// end.
namespace striate::python {

namespace py = pybind11;

/// Of this thread, which runs the mission and all that it calls.
void note_failure(std::exception_ptr failure);
/// Raises what was noted, if anything; the first, where there are several.
void raise_failure();
void forget_failure();

/// Runs `call` with the interpreter's lock. What it raises is noted, and goes on as an exception
/// that C++ understands.
/// @param who for the words: "the behaviour 'nod'"
template <class Call>
auto in_python(const std::string& who, Call call) {
  const py::gil_scoped_acquire lock;
  try {
    try {
      return call();
    } catch (const py::builtin_exception& error) {
      error.set_error();
      throw py::error_already_set();
    }
  } catch (const py::error_already_set& error) {
    std::string words = error.what();
    note_failure(std::current_exception());
    throw std::runtime_error(who + " failed: " + words.substr(0, words.find('\n')));
  }
}

}  // namespace striate::python
