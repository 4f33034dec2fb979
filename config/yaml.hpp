#pragma once

#include <string>

#include "striate/config/diagnostics.hpp"
#include "striate/config/node.hpp"

namespace striate::config {

/// Reads YAML text strictly: duplicate keys, anchors, aliases, tags, several documents, more than
/// 1 MB, 32 levels or 20,000 values are mistakes. Returns the root, of kind nothing if unreadable.
Node parse_yaml(const std::string& text, Diagnostics& diagnostics);

/// Reads a file; adds a mistake where it cannot be read.
Node load_yaml(Diagnostics& diagnostics);

}  // namespace striate::config
