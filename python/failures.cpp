#include "striate/python/failures.hpp"

#include <utility>

#include "striate/base/user_error.hpp"
#include "striate/python/bindings.hpp"
#include "striate/python/texts.hpp"

namespace striate::python {
namespace {

std::exception_ptr& noted() {
  thread_local std::exception_ptr failure;
  return failure;
}

}  // namespace

void note_failure(std::exception_ptr failure) {
  if (noted() == nullptr) noted() = std::move(failure);
}

void raise_failure() {
  if (noted() == nullptr) return;
  std::rethrow_exception(std::exchange(noted(), nullptr));
}

void forget_failure() {
  noted() = nullptr;
}

void bind_errors(py::module_& /*module*/) {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const UserError& error) {
      const py::object type = py::module_::import("striate._errors").attr("UserError");
      PyErr_SetObject(type.ptr(), text_of(error.what()).ptr());
    }
  });
}

}  // namespace striate::python
