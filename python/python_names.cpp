#include "striate/python/python_names.hpp"

#include <fmt/format.h>

#include "striate/base/entry_name.hpp"
#include "striate/base/user_error.hpp"

namespace striate::python {

void check_new_name(const std::string& kind, const std::string& name, bool taken) {
  if (!is_entry_name(name)) {
    throw UserError(fmt::format("a {} with the name '{}', which is none\n  hint: {}", kind, name,
                                kEntryNameRule));
  }
  if (taken) {
    throw UserError(
        fmt::format("a {} '{}', and that name is taken\n  hint: give it another name", kind, name));
  }
}

}  // namespace striate::python
