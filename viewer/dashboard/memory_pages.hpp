#pragma once

#include <string>

#include "striate/memory/long_term/long_term_settings.hpp"
#include "striate/viewer/dashboard/site.hpp"

namespace striate::viewer::dashboard {

/// A long-term memory as the page Memory shows it.
struct ShownMemory {
  std::string file;
  memory::LongTermSettings settings;
  bool changes = false;  ///< a person may rename, forget and restore
};

/// GET /api/memory, /api/memory/landmark, /api/memory/picture, /api/memory/episodes and, where it
/// may be changed, POST /api/memory/change. The file is opened for each of them alone, so a mission
/// may write into it meanwhile.
void add_memory_pages(Site& site, const ShownMemory& shown);

}  // namespace striate::viewer::dashboard
