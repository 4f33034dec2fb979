#include "striate/agent/run_result.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "striate/base/user_error.hpp"

namespace striate::agent {
namespace {

/// Six decimals: exact enough for people, the same text for the same run.
double rounded(double value) {
  return std::round(value * 1e6) / 1e6;
}

nlohmann::ordered_json to_json(const std::vector<CollisionRecord>& collisions) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const CollisionRecord& hit : collisions) {
    json.push_back({{"time_s", rounded(hit.time_s)},
                    {"along_m", rounded(hit.along_m)},
                    {"left_m", rounded(hit.left_m)},
                    {"hit", hit.hit},
                    {"light_level", rounded(hit.light_level)},
                    {"moving", hit.moving}});
  }
  return json;
}

nlohmann::ordered_json to_json(const std::vector<LateObstacleRecord>& late) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const LateObstacleRecord& one : late) {
    nlohmann::ordered_json entry = {{"name", one.name}, {"put_down", one.time_s.has_value()}};
    if (one.time_s) {
      entry["time_s"] = rounded(*one.time_s);
      entry["driven_m"] = rounded(one.driven_m);
    }
    json.push_back(std::move(entry));
  }
  return json;
}

RunOutcome outcome_from_json(const nlohmann::json& json) {
  const std::string name = json.get<std::string>();
  const std::optional<RunOutcome> outcome = outcome_named(name);
  if (!outcome) throw std::runtime_error(fmt::format("not the outcome of a run: '{}'", name));
  return *outcome;
}

/// What only a judge knows.
void read_judged(const nlohmann::json& json, RunResult& result) {
  for (const nlohmann::json& hit : json.at("collisions")) {
    result.collisions.push_back({hit.at("time_s"), hit.at("along_m"), hit.at("left_m"),
                                 hit.at("hit"), hit.at("light_level"), hit.at("moving")});
  }
  for (const nlohmann::json& one : json.value("late_obstacles", nlohmann::json::array())) {
    LateObstacleRecord& late = result.late_obstacles.emplace_back();
    one.at("name").get_to(late.name);
    if (!one.at("put_down").get<bool>()) continue;
    late.time_s = one.at("time_s").get<double>();
    one.at("driven_m").get_to(late.driven_m);
  }
  json.at("nearest_pass_m").get_to(result.nearest_pass_m);
  json.at("seed").get_to(result.seed);
}

}  // namespace

nlohmann::ordered_json to_json(const RunResult& result) {
  nlohmann::ordered_json json;
  json["outcome"] = name_of(result.outcome);
  json["reason"] = result.reason;
  if (!result.failure.empty()) {
    json["failure"] = {{"code", result.failure}, {"line", result.failure_line}};
  }
  json["reached_goal"] = result.reached_goal;
  if (result.judged) json["collisions"] = to_json(result.collisions);
  if (!result.late_obstacles.empty()) json["late_obstacles"] = to_json(result.late_obstacles);
  json["distance_m"] = rounded(result.distance_m);
  json["duration_s"] = rounded(result.duration_s);
  if (result.judged) json["nearest_pass_m"] = rounded(result.nearest_pass_m);
  json["emergency_stops"] = result.emergency_stops;
  json["longest_stand_s"] = rounded(result.longest_stand_s);
  if (result.from_start_m) json["from_start_m"] = rounded(*result.from_start_m);
  json["longest_stand_why"] = result.longest_stand_why;
  json["cycles"] = result.cycles;
  json["mean_cycle_ms"] = rounded(result.mean_cycle_ms);
  json["realtime_factor"] = rounded(result.realtime_factor);
  if (result.judged) json["seed"] = result.seed;
  json["world"] = result.world;
  json["task"] = result.task;
  json["emergency_layer"] = result.emergency_layer;
  if (!result.baseline.empty()) json["baseline"] = result.baseline;
  return json;
}

RunResult run_result_from_json(const nlohmann::json& json) {
  RunResult result;
  try {
    result.outcome = outcome_from_json(json.at("outcome"));
    json.at("reason").get_to(result.reason);
    if (json.contains("failure")) {
      json.at("failure").at("code").get_to(result.failure);
      json.at("failure").at("line").get_to(result.failure_line);
    }
    json.at("reached_goal").get_to(result.reached_goal);
    read_judged(json, result);
    json.at("distance_m").get_to(result.distance_m);
    json.at("duration_s").get_to(result.duration_s);
    json.at("emergency_stops").get_to(result.emergency_stops);
    json.at("longest_stand_s").get_to(result.longest_stand_s);
    if (json.contains("from_start_m")) result.from_start_m = json.at("from_start_m").get<double>();
    json.at("cycles").get_to(result.cycles);
    json.at("mean_cycle_ms").get_to(result.mean_cycle_ms);
    json.at("realtime_factor").get_to(result.realtime_factor);
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

std::string late_obstacles_text(const RunResult& result) {
  std::string text;
  for (const LateObstacleRecord& one : result.late_obstacles) {
    text += text.empty() ? "" : ", ";
    text += one.name + (one.time_s ? fmt::format(" after {:.0f} s", *one.time_s) : " never");
  }
  return text;
}

std::string stood_for(const RunResult& result) {
  return result.longest_stand_why.empty() ? "" : " (" + result.longest_stand_why + ")";
}

std::string outcome_text(const RunResult& result) {
  return fmt::format("{}{}", name_of(result.outcome),
                     result.reason.empty() ? "" : " (" + result.reason + ")");
}

}  // namespace striate::agent
