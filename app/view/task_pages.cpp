#include "striate/app/view/task_pages.hpp"

#include "striate/app/commands/action_list.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/tasks/task_reader.hpp"
#include "striate/viewer/channels/reports.hpp"

namespace striate::app {
namespace {

viewer::Json script_json(const std::string& file) {
  viewer::Json json = {{"file", file},
                       {"text", read_file(file)},
                       {"tree", nullptr},
                       {"mistakes", ""},
                       {"notices", ""}};
  try {
    const tasks::Task task = tasks::check_task(file, RobotDescription{});
    json["tree"] = viewer::task_tree(task.outline);
    json["notices"] = task.notices;
  } catch (const UserError& mistakes) {
    json["mistakes"] = mistakes.what();
  }
  return json;
}

}  // namespace

void add_task_pages(viewer::dashboard::Site& site, const std::string& file) {
  using viewer::dashboard::HttpRequest;
  using viewer::dashboard::json_answer;
  site.on_get("/api/task", [file](const HttpRequest&) { return json_answer(script_json(file)); });
  site.on_get("/api/actions", [](const HttpRequest&) { return json_answer(actions_as_json()); });
}

}  // namespace striate::app
