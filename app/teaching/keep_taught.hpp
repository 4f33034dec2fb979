#pragma once

#include <string>
#include <vector>

#include "memory/long_term/long_term_settings.hpp"
#include "memory/long_term/records.hpp"
#include "memory/long_term/teaching.hpp"

namespace striate {

/// Keeps views under a name in a teaching session of their own; on the disk when it returns.
/// @throws UserError where the memory cannot be opened or a view is too poor; nothing is kept then.
[[nodiscard]] Taught keep_taught(const std::string& memory, const std::string& name,
                                 const std::vector<StoredView>& views,
                                 const LongTermSettings& settings);

}  // namespace striate
