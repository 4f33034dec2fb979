#include <fmt/format.h>

#include <unordered_map>

#include "striate/agent/open_memory.hpp"
#include "striate/app/memory/json_number.hpp"
#include "striate/app/memory/memory_rows.hpp"
#include "striate/app/memory/memory_transfer.hpp"
#include "striate/base/user_error.hpp"

namespace striate::app {
namespace {

using Json = nlohmann::ordered_json;

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

}  // namespace

void import_memory(const std::string& text, const std::string& file, memory::MemoryTables& tables) {
  try {
    const Json json = parse_shallow(text);
    if (!json.is_object() || json.value("striate_memory", Json()) != Json(kMemoryExport)) {
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
