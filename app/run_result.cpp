#include "app/run_result.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "base/user_error.hpp"

namespace striate {
namespace {

/// Six decimals: exact enough for people, the same text for the same run.
double rounded(double value) {
  return std::round(value * 1e6) / 1e6;
}

}  // namespace

nlohmann::ordered_json to_json(const RunResult& result) {
  nlohmann::ordered_json json;
  json["outcome"] = result.outcome;
  json["reason"] = result.reason;
  json["reached_goal"] = result.reached_goal;
  json["collisions"] = nlohmann::ordered_json::array();
  for (const CollisionRecord& hit : result.collisions) {
    json["collisions"].push_back({{"time_s", rounded(hit.time_s)},
                                  {"along_m", rounded(hit.along_m)},
                                  {"left_m", rounded(hit.left_m)},
                                  {"hit", hit.hit},
                                  {"light_level", rounded(hit.light_level)},
                                  {"moving", hit.moving}});
  }
  json["distance_m"] = rounded(result.distance_m);
  json["duration_s"] = rounded(result.duration_s);
  json["nearest_pass_m"] = rounded(result.nearest_pass_m);
  json["emergency_stops"] = result.emergency_stops;
  json["longest_stand_s"] = rounded(result.longest_stand_s);
  if (result.from_start_m) json["from_start_m"] = rounded(*result.from_start_m);
  json["longest_stand_why"] = result.longest_stand_why;
  json["cycles"] = result.cycles;
  json["mean_cycle_ms"] = rounded(result.mean_cycle_ms);
  json["realtime_factor"] = rounded(result.realtime_factor);
  json["seed"] = result.seed;
  json["world"] = result.world;
  json["task"] = result.task;
  json["emergency_layer"] = result.emergency_layer;
  if (!result.baseline.empty()) json["baseline"] = result.baseline;
  return json;
}

RunResult run_result_from_json(const nlohmann::json& json) {
  RunResult result;
  try {
    json.at("outcome").get_to(result.outcome);
    json.at("reason").get_to(result.reason);
    json.at("reached_goal").get_to(result.reached_goal);
    for (const nlohmann::json& hit : json.at("collisions")) {
      result.collisions.push_back({hit.at("time_s"), hit.at("along_m"), hit.at("left_m"),
                                   hit.at("hit"), hit.at("light_level"), hit.at("moving")});
    }
    json.at("distance_m").get_to(result.distance_m);
    json.at("duration_s").get_to(result.duration_s);
    json.at("nearest_pass_m").get_to(result.nearest_pass_m);
    json.at("emergency_stops").get_to(result.emergency_stops);
    json.at("longest_stand_s").get_to(result.longest_stand_s);
    if (json.contains("from_start_m")) result.from_start_m = json.at("from_start_m").get<double>();
    json.at("cycles").get_to(result.cycles);
    json.at("mean_cycle_ms").get_to(result.mean_cycle_ms);
    json.at("realtime_factor").get_to(result.realtime_factor);
    json.at("seed").get_to(result.seed);
    json.at("world").get_to(result.world);
    json.at("task").get_to(result.task);
    json.at("emergency_layer").get_to(result.emergency_layer);
    result.longest_stand_why = json.value("longest_stand_why", std::string());
    result.baseline = json.value("baseline", std::string());
  } catch (const nlohmann::json::exception& error) {
    throw std::runtime_error(fmt::format("not the result of a run: {}", error.what()));
  }
  return result;
}

std::string stood_for(const RunResult& result) {
  return result.longest_stand_why.empty() ? "" : " (" + result.longest_stand_why + ")";
}

int exit_code_of(const RunResult& result) {
  if (result.outcome == "success") return 0;
  return result.outcome == "interrupted" ? 130 : 1;
}

}  // namespace striate
