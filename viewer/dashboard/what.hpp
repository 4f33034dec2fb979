#pragma once

#include <string>
#include <vector>

#include "striate/viewer/dashboard/site.hpp"

namespace striate::viewer::dashboard {

/// What the page is told first: what it shows, and what may be done with it.
struct What {
  std::string kind;                ///< "run", "replay", "file"
  std::string title;               ///< for a person: "corridor in short, seed 3"
  std::vector<std::string> pages;  ///< "live", "memory", "recording", "trials", "task"
  bool drives = false;             ///< by keys
  bool changes = false;            ///< the memory may be changed
};

/// GET /api/what
void add_what(Site& site, const What& what);

}  // namespace striate::viewer::dashboard
