#pragma once

#include <string>

#include "striate/viewer/dashboard/site.hpp"

namespace striate::app {

/// Whether a folder is one that `striate trial --out` writes.
[[nodiscard]] bool is_trial_folder(const std::string& folder);

/// GET /api/trials: the table and each finished run with the command that drives it again; read
/// anew each time, so that a trial that goes on can be watched.
void add_trial_pages(viewer::dashboard::Site& site, const std::string& folder);

}  // namespace striate::app
