#include "striate/app/memory/memory_transfer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "striate/agent/memory_json.hpp"
#include "striate/app/memory/base64.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/teaching.hpp"
#include "striate/memory/long_term/view_codec.hpp"

namespace striate::app {
namespace {

using Json = nlohmann::ordered_json;
constexpr int kFormat = 1;  // version of the exported file; a reader refuses others

template <class T>
std::optional<T> maybe(const Json& json, const char* key) {
  const Json& value = json.at(key);
  return value.is_null() ? std::nullopt : std::optional<T>(value.get<T>());
}

memory::Session session_of(const Json& json) {
  memory::Session session;
  const std::string kind = json.at("kind");
  for (const memory::SessionKind one : {memory::SessionKind::teach, memory::SessionKind::mission,
                                        memory::SessionKind::replay, memory::SessionKind::import}) {
    if (kind == name_of(one)) session.kind = one;
  }
  session.state =
      json.at("state") == "crashed" ? memory::SessionState::crashed : memory::SessionState::closed;
  json.at("started_unix_s").get_to(session.started_unix_s);
  json.at("operating_start_s").get_to(session.operating_start_s);
  json.at("operating_s").get_to(session.operating_s);
  json.at("software").get_to(session.software);
  json.at("settings").get_to(session.settings);
  json.at("outcome").get_to(session.outcome);
  return session;
}

memory::Landmark landmark_of(const Json& json) {
  memory::Landmark landmark;
  json.at("name").get_to(landmark.name);
  memory::check_landmark_name(landmark.name);
  landmark.kind =
      json.at("kind") == "taught" ? memory::LandmarkKind::taught : memory::LandmarkKind::candidate;
  if (const Json& at = json.at("position"); !at.is_null()) {
    landmark.position = memory::MapPosition{at.at("x_m"), at.at("y_m"), at.at("var_x_m2"),
                                            at.at("cov_xy_m2"), at.at("var_y_m2")};
  }
  json.at("strength").get_to(landmark.strength);
  json.at("uses").get_to(landmark.history.uses);
  json.at("first_use_s").get_to(landmark.history.first_s);
  json.at("recent_uses_s").get_to(landmark.history.recent_s);
  json.at("pinned").get_to(landmark.pinned);
  landmark.retired_s = maybe<double>(json, "retired_s");
  json.at("retired_why").get_to(landmark.retired_why);
  return landmark;
}

memory::StoredView view_of(const Json& json) {
  memory::StoredView view;
  json.at("width_px").get_to(view.width_px);
  json.at("height_px").get_to(view.height_px);
  view.range_m = maybe<double>(json, "range_m");
  view.bearing_rad = maybe<double>(json, "bearing_rad");
  memory::unpack(from_base64(json.at("descriptor_bytes")), view.descriptors);
  memory::unpack(from_base64(json.at("keypoint_bytes")), view.keypoints);
  view.image = from_base64(json.at("picture"));
  if (view.descriptors.size() != view.keypoints.size() || view.keypoints.empty()) {
    throw std::invalid_argument("a view whose descriptors and keypoints do not fit together");
  }
  return view;
}

memory::Episode episode_of(const Json& json) {
  memory::Episode episode;
  json.at("time_s").get_to(episode.time_s);
  json.at("kind").get_to(episode.kind);
  episode.x_m = maybe<double>(json, "x_m");
  episode.y_m = maybe<double>(json, "y_m");
  episode.heading_rad = maybe<double>(json, "heading_rad");
  json.at("landmark").get_to(episode.landmark);
  json.at("text").get_to(episode.text);
  return episode;
}

void fill(const Json& json, memory::MemoryTables& tables) {
  std::unordered_map<std::int64_t, std::int64_t> sessions;
  std::unordered_map<std::int64_t, std::int64_t> landmarks;
  for (const Json& one : json.at("sessions")) {
    sessions[one.at("id")] = tables.sessions.adopt(session_of(one));
  }
  for (const Json& one : json.at("landmarks")) {
    memory::Landmark landmark = landmark_of(one);
    landmark.session = sessions.at(one.at("session"));
    const std::int64_t id = tables.landmarks.add(landmark);
    landmarks[one.at("id")] = id;
    for (const Json& look : one.at("looks")) {
      memory::StoredView view = view_of(look);
      view.landmark = id;
      view.session = sessions.at(look.at("session"));
      tables.views.add(view);
    }
  }
  for (const Json& one : json.at("routes")) {
    tables.places.put(memory::Route{landmarks.at(one.at("from")), landmarks.at(one.at("to")),
                                    one.at("distance_m"), one.at("turn_rad"),
                                    one.at("distance_var_m2"), one.at("turn_var_rad2"),
                                    one.at("successes"), one.at("failures")});
  }
  for (const Json& one : json.at("obstacle_cells")) {
    tables.places.put(memory::ObstacleCell{one.at("column"), one.at("row"), one.at("log_odds"),
                                           one.at("seen_s")});
  }
  for (const Json& one : json.at("episodes")) {
    memory::Episode episode = episode_of(one);
    if (const auto session = maybe<std::int64_t>(one, "session")) {
      episode.session = sessions.at(*session);
    }
    tables.sessions.add(episode);
  }
}

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
  json["striate_memory"] = kFormat;
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

void import_memory(const std::string& text, const std::string& file, memory::MemoryTables& tables) {
  try {
    const Json json = Json::parse(text);
    if (!json.is_object() || json.value("striate_memory", 0) != kFormat) {
      throw std::invalid_argument("it does not begin with \"striate_memory\": 1");
    }
    fill(json, tables);
  } catch (const SQLite::Exception& error) {
    throw UserError(
        fmt::format("{}: a value that cannot be in a memory: {}\n    nothing was taken "
                    "over; export it anew",
                    file, error.what()));
  } catch (const std::exception& error) {
    throw UserError(
        fmt::format("{}: no export of a memory: {}\n    give a file that 'striate "
                    "memory FILE export' wrote",
                    file, error.what()));
  }
}

}  // namespace striate::app
