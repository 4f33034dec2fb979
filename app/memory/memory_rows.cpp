#include "striate/app/memory/memory_rows.hpp"

#include <cmath>

#include "striate/app/memory/json_number.hpp"
#include "striate/base/base64.hpp"
#include "striate/memory/long_term/teaching.hpp"
#include "striate/memory/long_term/view_codec.hpp"

namespace striate::app {
namespace {

using Json = nlohmann::ordered_json;

std::vector<double> times_at(const Json& json, const char* key) {
  std::vector<double> times_s;
  for (const Json& one : json.at(key))
    times_s.push_back(real_at({{key, one}}, key, taken::kTime_s));
  if (times_s.size() > memory::UseHistory::kKept) times_s.resize(memory::UseHistory::kKept);
  return times_s;
}

}  // namespace

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

}  // namespace striate::app
