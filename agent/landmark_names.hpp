#pragma once

#include <string>
#include <vector>

namespace striate::agent {

/// The names of the landmarks that a memory knows; none where the file is still to be made.
/// @throws UserError where it cannot be read.
[[nodiscard]] std::vector<std::string> landmark_names_in(const std::string& memory);

}  // namespace striate::agent
