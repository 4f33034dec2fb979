#include "striate/app/memory/memory_transfer.hpp"

#include <algorithm>

#include "striate/agent/memory_json.hpp"
#include "striate/agent/open_memory.hpp"
#include "striate/base/base64.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/memory_errors.hpp"
#include "striate/memory/long_term/memory_file.hpp"
#include "striate/memory/long_term/salvage.hpp"
#include "striate/memory/long_term/view_codec.hpp"

namespace striate::app {
namespace {

using Json = nlohmann::ordered_json;

template <class Rows>
Json oldest_first(Rows rows) {
  Json list = Json::array();
  std::for_each(rows.rbegin(), rows.rend(),
                [&](const auto& row) { list.push_back(agent::to_json(row)); });
  return list;
}

}  // namespace

Json export_memory(memory::MemoryTables& tables) {
  Json json;
  json["striate_memory"] = kMemoryExport;
  json["sessions"] = oldest_first(tables.sessions.all());
  json["landmarks"] = Json::array();
  int damaged = 0;
  for (const memory::Landmark& landmark : tables.landmarks.all(true)) {
    Json one = agent::to_json(landmark);
    one["looks"] = Json::array();
    for (const memory::StoredView& view : tables.views.of(landmark.id)) {
      damaged += view.damaged ? 1 : 0;
      if (view.damaged) continue;
      Json look = agent::to_json(view);
      look["descriptor_bytes"] = to_base64(memory::bytes_of(view.descriptors));
      look["keypoint_bytes"] = to_base64(memory::bytes_of(view.keypoints));
      look["picture"] = to_base64(view.image);
      one["looks"].push_back(std::move(look));
    }
    json["landmarks"].push_back(std::move(one));
  }
  json["routes"] = Json::array();
  for (const memory::Route& route : tables.places.routes())
    json["routes"].push_back(agent::to_json(route));
  json["obstacle_cells"] = Json::array();
  for (const memory::ObstacleCell& cell : tables.places.cells()) {
    json["obstacle_cells"].push_back(agent::to_json(cell));
  }
  json["episodes"] = oldest_first(tables.sessions.episodes(-1));
  json["damaged_views_left_out"] = damaged;
  return json;
}

Json export_readable(const std::string& file) {
  const ScratchFolder scratch;
  const std::string filled_up = scratch / "filled_up.db";
  const bool whole = !memory::fill_up(file, filled_up);
  Json json;
  agent::with_memory(whole ? file : filled_up, memory::Access::read, "exporting it",
                     [&](memory::MemoryTables& tables, memory::MemoryFile& opened) {
                       try {
                         json = export_memory(tables);
                         return;
                       } catch (const SQLite::Exception& error) {
                         if (!memory::is_damage(error)) throw;
                       }
                       memory::MemoryFile copy(
                           scratch / "readable.db",
                           agent::memory_options(memory::Access::session, "striate memory"));
                       const auto left_out = memory::salvage(opened.database(), copy.database());
                       memory::MemoryTables copied(copy.database());
                       json = export_memory(copied);
                       json["rows_left_out"] = left_out;
                     });
  return json;
}

}  // namespace striate::app
