#include "striate/python/python_names.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "striate/base/user_error.hpp"

namespace striate::python {

void check_new_name(const std::string& kind, const std::string& name, bool taken) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  };
  if (name.empty() || name[0] < 'a' || name[0] > 'z' || !std::ranges::all_of(name, fits)) {
    throw UserError(fmt::format(
        "a {} with the name '{}', which is none\n  hint: a name is a small letter, then small "
        "letters, digits and '_'",
        kind, name));
  }
  if (taken) {
    throw UserError(
        fmt::format("a {} '{}', and that name is taken\n  hint: give it another name", kind, name));
  }
}

}  // namespace striate::python
