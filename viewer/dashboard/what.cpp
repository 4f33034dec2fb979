#include "striate/viewer/dashboard/what.hpp"

#include "striate/base/version.hpp"

namespace striate::viewer::dashboard {

void add_what(Site& site, const What& what) {
  const nlohmann::ordered_json json = {{"kind", what.kind},       {"title", what.title},
                                       {"pages", what.pages},     {"drives", what.drives},
                                       {"changes", what.changes}, {"version", kVersion}};
  site.on_get("/api/what", [json](const HttpRequest&) { return json_answer(json); });
}

}  // namespace striate::viewer::dashboard
