#pragma once

#include <pybind11/pybind11.h>

#include <optional>
#include <string>

#include "striate/behaviours/control/wish.hpp"

namespace striate::python {

/// What Python's behaviours and pilots want; the class Wish of the module.
struct AskedWish {
  double forward_m_s = 0.0;
  double turn_rad_s = 0.0;
  double pan_rad = 0.0;
  std::optional<double> tilt_rad;  ///< none: as the head rests
  behaviours::Progress progress = behaviours::Progress::running;
  std::string why;
};

/// As the cycle takes it, of now.
/// @throws UserError for numbers that are not finite
[[nodiscard]] behaviours::Wish wish_of(const AskedWish& asked,
                                       const memory::ShortTermMemory& memory);
/// As Python sees one that the cycle had.
[[nodiscard]] AskedWish asked_of(const behaviours::Wish& wish);

/// What a call came back with. @param who for the message: "the behaviour 'nod'"
/// @throws py::type_error for what is no Wish
[[nodiscard]] const AskedWish& returned_wish(const pybind11::object& given, const std::string& who);

void bind_wish(pybind11::module_& module);

}  // namespace striate::python
