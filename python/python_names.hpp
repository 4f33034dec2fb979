#pragma once

#include <string>

namespace striate::python {

/// @param kind "behaviour" @param taken somebody else has it
/// @throws UserError
void check_new_name(const std::string& kind, const std::string& name, bool taken);

}  // namespace striate::python
