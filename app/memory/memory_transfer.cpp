#include "striate/app/memory/memory_transfer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "striate/agent/memory_json.hpp"
#include "striate/agent/open_memory.hpp"
#include "striate/app/memory/base64.hpp"
#include "striate/app/memory/json_number.hpp"
#include "striate/base/files.hpp"
#include "striate/base/user_error.hpp"
#include "striate/memory/long_term/memory_errors.hpp"
#include "striate/memory/long_term/memory_file.hpp"
#include "striate/memory/long_term/salvage.hpp"
#include "striate/memory/long_term/teaching.hpp"
#include "striate/memory/long_term/view_codec.hpp"

namespace striate::app {
namespace {

using Json = nlohmann::ordered_json;
constexpr int kFormat = 1;  // version of the exported file; a reader refuses others

memory::Session session_of(const Json& json) {
  memory::Session session;
  const std::string kind = json.at("kind");
  for (const memory::SessionKind one : {memory::SessionKind::teach, memory::SessionKind::mission,
                                        memory::SessionKind::replay, memory::SessionKind::import}) {
    if (kind == name_of(one)) session.kind = one;
  }
  session.state =
      json.at("state") == "crashed" ? memory::SessionState::crashed : memory::SessionState::closed;
  session.started_unix_s = whole_at(json, "started_unix_s", taken::kTime_s);
  session.operating_start_s = real_at(json, "operating_start_s", taken::kTime_s);
  session.operating_s = real_at(json, "operating_s", taken::kTime_s);
  json.at("software").get_to(session.software);
  json.at("settings").get_to(session.settings);
  json.at("outcome").get_to(session.outcome);
  return session;
}

std::vector<double> times_at(const Json& json, const char* key) {
  std::vector<double> times_s;
  for (const Json& one : json.at(key))
    times_s.push_back(real_at({{key, one}}, key, taken::kTime_s));
  if (times_s.size() > memory::UseHistory::kKept) times_s.resize(memory::UseHistory::kKept);
  return times_s;
}

memory::Landmark landmark_of(const Json& json) {
  memory::Landmark landmark;
  json.at("name").get_to(landmark.name);
  memory::check_landmark_name(landmark.name);
  landmark.kind =
      json.at("kind") == "taught" ? memory::LandmarkKind::taught : memory::LandmarkKind::candidate;
  if (const Json& at = json.at("position"); !at.is_null()) {
    landmark.position = memory::MapPosition{
        real_at(at, "x_m", taken::kPlace_m), real_at(at, "y_m", taken::kPlace_m),
        real_at(at, "var_x_m2", taken::kVariance), real_at(at, "cov_xy_m2", taken::kCovariance),
        real_at(at, "var_y_m2", taken::kVariance)};
  }
  landmark.strength = real_at(json, "strength", taken::kShare);
  landmark.history.uses = whole_at(json, "uses", taken::kCount);
  landmark.history.first_s = real_at(json, "first_use_s", taken::kTime_s);
  landmark.history.recent_s = times_at(json, "recent_uses_s");
  json.at("pinned").get_to(landmark.pinned);
  landmark.retired_s = maybe_real_at(json, "retired_s", taken::kTime_s);
  json.at("retired_why").get_to(landmark.retired_why);
  return landmark;
}

memory::StoredView view_of(const Json& json) {
  memory::StoredView view;
  view.width_px = real_at(json, "width_px", taken::kSide_px);
  view.height_px = real_at(json, "height_px", taken::kSide_px);
  view.range_m = maybe_real_at(json, "range_m", taken::kPlace_m);
  view.bearing_rad = maybe_real_at(json, "bearing_rad", taken::kAngle_rad);
  memory::unpack(from_base64(json.at("descriptor_bytes")), view.descriptors);
  memory::unpack(from_base64(json.at("keypoint_bytes")), view.keypoints);
  view.image = from_base64(json.at("picture"));
  if (view.descriptors.size() != view.keypoints.size() || view.keypoints.empty()) {
    throw std::invalid_argument("a view whose descriptors and keypoints do not fit together");
  }
  for (const perception::ViewKeypoint& point : view.keypoints) {
    const auto fits = [](float px) { return std::abs(px) <= taken::kSide_px.most; };
    if (fits(point.x_px) && fits(point.y_px) && fits(point.size_px) &&
        std::isfinite(point.angle_rad)) {
      continue;
    }
    throw std::invalid_argument("a view with a keypoint that is in no image");
  }
  return view;
}

memory::Episode episode_of(const Json& json) {
  memory::Episode episode;
  episode.time_s = real_at(json, "time_s", taken::kTime_s);
  json.at("kind").get_to(episode.kind);
  episode.x_m = maybe_real_at(json, "x_m", taken::kPlace_m);
  episode.y_m = maybe_real_at(json, "y_m", taken::kPlace_m);
  episode.heading_rad = maybe_real_at(json, "heading_rad", taken::kAngle_rad);
  json.at("landmark").get_to(episode.landmark);
  json.at("text").get_to(episode.text);
  return episode;
}

void fill(const Json& json, memory::MemoryTables& tables) {
  std::unordered_map<std::int64_t, std::int64_t> sessions;
  std::unordered_map<std::int64_t, std::int64_t> landmarks;
  for (const Json& one : json.at("sessions")) {
    sessions[whole_at(one, "id", taken::kId)] = tables.sessions.adopt(session_of(one));
  }
  for (const Json& one : json.at("landmarks")) {
    memory::Landmark landmark = landmark_of(one);
    landmark.session = sessions.at(whole_at(one, "session", taken::kId));
    const std::int64_t id = tables.landmarks.add(landmark);
    landmarks[whole_at(one, "id", taken::kId)] = id;
    for (const Json& look : one.at("looks")) {
      memory::StoredView view = view_of(look);
      view.landmark = id;
      view.session = sessions.at(whole_at(look, "session", taken::kId));
      tables.views.add(view);
    }
  }
  for (const Json& one : json.at("routes")) {
    tables.places.put(memory::Route{
        landmarks.at(whole_at(one, "from", taken::kId)),
        landmarks.at(whole_at(one, "to", taken::kId)), real_at(one, "distance_m", taken::kPlace_m),
        real_at(one, "turn_rad", taken::kAngle_rad),
        real_at(one, "distance_var_m2", taken::kVariance),
        real_at(one, "turn_var_rad2", taken::kVariance), whole_at(one, "successes", taken::kCount),
        whole_at(one, "failures", taken::kCount)});
  }
  for (const Json& one : json.at("obstacle_cells")) {
    tables.places.put(memory::ObstacleCell{static_cast<int>(whole_at(one, "column", taken::kCell)),
                                           static_cast<int>(whole_at(one, "row", taken::kCell)),
                                           real_at(one, "log_odds", taken::kLogOdds),
                                           real_at(one, "seen_s", taken::kTime_s)});
  }
  for (const Json& one : json.at("episodes")) {
    memory::Episode episode = episode_of(one);
    if (!one.at("session").is_null()) {
      episode.session = sessions.at(whole_at(one, "session", taken::kId));
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

void import_memory(const std::string& text, const std::string& file, memory::MemoryTables& tables) {
  try {
    const Json json = parse_shallow(text);
    if (!json.is_object() || json.value("striate_memory", Json()) != Json(kFormat)) {
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
