#pragma once

#include <string>

#include "striate/viewer/dashboard/site.hpp"

namespace striate::app {

/// GET /api/task: a script, its tree and its mistakes, read anew each time, so that who edits it
/// sees what has become of it; GET /api/actions: what scripts can be made of.
void add_task_pages(viewer::dashboard::Site& site, const std::string& file);

}  // namespace striate::app
