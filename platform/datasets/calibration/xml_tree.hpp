#pragma once

#include <string>

#include "striate/config/diagnostics.hpp"
#include "striate/config/node.hpp"

namespace striate::datasets {

/// The little of XML that calibrations are written in: elements, attributes (passed over),
/// comments, a prolog, the five named entities. The result is a map with the root element as its
/// only key. Adds a mistake for anything else, for more than 1 MB, 32 levels or 20,000 elements.
[[nodiscard]] config::Node read_xml(const std::string& text, config::Diagnostics& diagnostics);

}  // namespace striate::datasets
