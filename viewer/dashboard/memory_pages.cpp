#include "striate/viewer/dashboard/memory_pages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "striate/agent/memory_json.hpp"
#include "striate/agent/open_memory.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/activation.hpp"
#include "striate/memory/long_term/forgetting.hpp"

namespace striate::viewer::dashboard {
namespace {

using MemoryJson = nlohmann::ordered_json;

/// Episodes that the page gets where it does not say how many, by hand: weeks of missions
constexpr int kMostEpisodes = 2000;

/// Reads in one transaction. @return what `work` makes of the tables
template <class Work>
MemoryJson read_memory(const ShownMemory& shown, Work work) {
  MemoryJson json;
  agent::with_memory(
      shown.file, memory::Access::read, "showing it",
      [&](memory::MemoryTables& tables, memory::MemoryFile&) { json = work(tables); });
  return json;
}

MemoryJson landmark_json(const memory::Landmark& landmark, const memory::Situation& situation,
                         const std::vector<memory::Route>& routes,
                         const memory::LongTermSettings& settings) {
  MemoryJson json = agent::to_json(landmark);
  // Never used: minus infinity, which JSON has not.
  const double activation = memory::activation_of(landmark, situation, routes, settings).total();
  json["activation"] = std::isfinite(activation) ? MemoryJson(activation) : MemoryJson(nullptr);
  json["why"] = memory::explain(landmark, situation, routes, settings);
  json["fate"] = agent::fate_of(landmark, situation.now_s, settings);
  return json;
}

/// All but views and episodes: what the list and the map need.
MemoryJson overview_json(const ShownMemory& shown, memory::MemoryTables& tables) {
  const memory::Situation situation{tables.sessions.operating_now_s(), 0, {}};
  const std::vector<memory::Route> routes = tables.places.routes();
  MemoryJson json = {{"file", shown.file},
                     {"changes", shown.changes},
                     {"now_s", situation.now_s},
                     {"landmarks", MemoryJson::array()},
                     {"routes", MemoryJson::array()},
                     {"cell_m", memory::kObstacleCell_m},
                     {"cells", MemoryJson::array()},
                     {"sessions", MemoryJson::array()}};
  for (const memory::Landmark& one : tables.landmarks.all(true)) {
    json["landmarks"].push_back(landmark_json(one, situation, routes, shown.settings));
    MemoryJson& views = json["landmarks"].back()["looks"] = MemoryJson::array();
    for (const memory::StoredView& view : tables.views.of(one.id)) {
      views.push_back(agent::to_json(view));
    }
  }
  for (const memory::Route& one : routes) json["routes"].push_back(agent::to_json(one));
  for (const memory::ObstacleCell& one : tables.places.cells()) {
    json["cells"].push_back({one.column, one.row, one.log_odds});
  }
  for (const memory::Session& one : tables.sessions.all()) {
    json["sessions"].push_back(agent::to_json(one));
  }
  return json;
}

MemoryJson episodes_json(memory::MemoryTables& tables) {
  MemoryJson list = MemoryJson::array();
  for (const memory::Episode& one : tables.sessions.episodes(kMostEpisodes)) {
    list.push_back(agent::to_json(one));
  }
  return list;
}

/// The image of one view, as it is stored.
HttpAnswer picture_answer(const ShownMemory& shown, const HttpRequest& request) {
  const std::string name = query_value(request.query, "name");
  const std::string number = query_value(request.query, "view");
  HttpAnswer answer = error_answer(404, "there is no such picture");
  read_memory(shown, [&](memory::MemoryTables& tables) {
    for (const memory::StoredView& view : tables.views.of(memory::find_landmark(tables, name).id)) {
      if (std::to_string(view.id) != number || view.image.empty()) continue;
      answer = {200, "image/jpeg", std::string(view.image.begin(), view.image.end())};
    }
    return MemoryJson();
  });
  return answer;
}

/// Keypoints of a view, as pixels of its picture.
MemoryJson keypoints_of(memory::MemoryTables& tables, const HttpRequest& request) {
  const std::string number = query_value(request.query, "view");
  const memory::Landmark landmark =
      memory::find_landmark(tables, query_value(request.query, "name"));
  MemoryJson list = MemoryJson::array();
  for (const memory::StoredView& view : tables.views.of(landmark.id)) {
    if (std::to_string(view.id) != number) continue;
    for (const perception::ViewKeypoint& one : view.keypoints) list.push_back({one.x_px, one.y_px});
  }
  return list;
}

std::string text_in(const MemoryJson& json, const char* key) {
  const auto found = json.find(key);
  if (found == json.end() || !found->is_string()) {
    throw UserError(fmt::format("the change has no '{}'", key));
  }
  return found->get<std::string>();
}

/// The verbs of `striate memory`. @return what was done, in words
std::string change(memory::MemoryTables& tables, const MemoryJson& asked) {
  const std::string what = text_in(asked, "what");
  const std::string name = text_in(asked, "name");
  if (what == "rename") {
    const std::string to = text_in(asked, "to");
    memory::rename(tables, name, to);
    return fmt::format("{} is called {} now", name, to);
  }
  if (what == "forget") {
    memory::forget(tables, name, "a person asked for it");
    return name + " is forgotten; it can be restored";
  }
  if (what == "restore") {
    memory::restore(tables, name);
    return name + " is back, and pinned";
  }
  throw UserError(fmt::format("'{}' is no change: rename, forget, restore", what));
}

HttpAnswer change_answer(const ShownMemory& shown, const HttpRequest& request) {
  const MemoryJson asked = MemoryJson::parse(request.body, nullptr, false);
  if (!asked.is_object()) return error_answer(400, "a change is a JSON object");
  std::string done;
  agent::with_memory(
      shown.file, memory::Access::edit, "changing it",
      [&](memory::MemoryTables& tables, memory::MemoryFile&) { done = change(tables, asked); });
  return json_answer({{"done", done}});
}

}  // namespace

void add_memory_pages(Site& site, const ShownMemory& shown) {
  site.on_get("/api/memory", [shown](const HttpRequest&) {
    return json_answer(read_memory(
        shown, [&](memory::MemoryTables& tables) { return overview_json(shown, tables); }));
  });
  site.on_get("/api/memory/keypoints", [shown](const HttpRequest& request) {
    return json_answer(read_memory(
        shown, [&](memory::MemoryTables& tables) { return keypoints_of(tables, request); }));
  });
  site.on_get("/api/memory/picture",
              [shown](const HttpRequest& request) { return picture_answer(shown, request); });
  site.on_get("/api/memory/episodes", [shown](const HttpRequest&) {
    return json_answer(
        read_memory(shown, [&](memory::MemoryTables& tables) { return episodes_json(tables); }));
  });
  if (!shown.changes) return;
  site.on_post("/api/memory/change",
               [shown](const HttpRequest& request) { return change_answer(shown, request); });
}

}  // namespace striate::viewer::dashboard
