#include "striate/agent/memory_json.hpp"

#include "striate/memory/long_term/forgetting.hpp"

namespace striate::agent {
namespace {

template <class T>
nlohmann::ordered_json maybe(const std::optional<T>& value) {
  return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

}  // namespace

nlohmann::ordered_json to_json(const memory::Landmark& landmark) {
  nlohmann::ordered_json json;
  json["id"] = landmark.id;
  json["session"] = landmark.session;
  json["name"] = landmark.name;
  json["kind"] = name_of(landmark.kind);
  json["position"] = nullptr;
  if (landmark.position) {
    const memory::MapPosition& at = *landmark.position;
    json["position"] = {{"x_m", at.x_m},
                        {"y_m", at.y_m},
                        {"var_x_m2", at.var_x_m2},
                        {"cov_xy_m2", at.cov_xy_m2},
                        {"var_y_m2", at.var_y_m2}};
  }
  json["strength"] = landmark.strength;
  json["uses"] = landmark.history.uses;
  json["first_use_s"] = landmark.history.first_s;
  json["recent_uses_s"] = landmark.history.recent_s;
  json["pinned"] = landmark.pinned;
  json["retired_s"] = maybe(landmark.retired_s);
  json["retired_why"] = landmark.retired_why;
  json["views"] = landmark.views;
  json["keypoints"] = landmark.keypoints;
  return json;
}

nlohmann::ordered_json to_json(const memory::StoredView& view) {
  return {{"id", view.id},
          {"session", view.session},
          {"width_px", view.width_px},
          {"height_px", view.height_px},
          {"keypoints", view.keypoints.size()},
          {"range_m", maybe(view.range_m)},
          {"bearing_rad", maybe(view.bearing_rad)},
          {"picture_bytes", view.image.size()},
          {"damaged", view.damaged}};
}

nlohmann::ordered_json to_json(const memory::Episode& episode) {
  return {{"id", episode.id},
          {"session", maybe(episode.session)},
          {"time_s", episode.time_s},
          {"kind", episode.kind},
          {"x_m", maybe(episode.x_m)},
          {"y_m", maybe(episode.y_m)},
          {"heading_rad", maybe(episode.heading_rad)},
          {"landmark", episode.landmark},
          {"text", episode.text}};
}

nlohmann::ordered_json to_json(const memory::Session& session) {
  return {{"id", session.id},
          {"kind", name_of(session.kind)},
          {"state", name_of(session.state)},
          {"started_unix_s", session.started_unix_s},
          {"operating_start_s", session.operating_start_s},
          {"operating_s", session.operating_s},
          {"software", session.software},
          {"settings", session.settings},
          {"outcome", session.outcome}};
}

nlohmann::ordered_json to_json(const memory::Route& route) {
  return {{"from", route.from},
          {"to", route.to},
          {"distance_m", route.distance_m},
          {"turn_rad", route.turn_rad},
          {"distance_var_m2", route.distance_var_m2},
          {"turn_var_rad2", route.turn_var_rad2},
          {"successes", route.successes},
          {"failures", route.failures}};
}

nlohmann::ordered_json to_json(const memory::ObstacleCell& cell) {
  return {{"column", cell.column},
          {"row", cell.row},
          {"log_odds", cell.log_odds},
          {"seen_s", cell.seen_s}};
}

std::string fate_of(const memory::Landmark& landmark, double now_s,
                    const memory::LongTermSettings& settings) {
  if (landmark.retired_s) return "it is forgotten: " + landmark.retired_why;
  const std::string forgettable = memory::why_forgettable(landmark, now_s, settings);
  if (!forgettable.empty()) return "the next prune forgets it: " + forgettable;
  if (landmark.pinned) return "it is pinned, so it is not forgotten";
  if (landmark.kind == memory::LandmarkKind::taught) {
    return "a person taught it, so it is not forgotten";
  }
  return "it is not forgotten: strong or active";
}

std::string print_json(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace striate::agent
