#pragma once

#include <string>
#include <vector>

#include "striate/memory/long_term/long_term_settings.hpp"
#include "striate/memory/long_term/records.hpp"
#include "striate/memory/long_term/teaching.hpp"

namespace striate::agent {

/// Keeps views under a name in a teaching session of their own; on the disk when it returns.
/// @throws UserError where the memory cannot be opened or a view is too poor; nothing is kept then.
[[nodiscard]] memory::Taught keep_taught(const std::string& memory, const std::string& name,
                                         const std::vector<memory::StoredView>& views,
                                         const memory::LongTermSettings& settings);

}  // namespace striate::agent
