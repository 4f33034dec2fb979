#include "striate/agent/recall/memory_state.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <utility>

#include "striate/base/user_error.hpp"

namespace striate::agent {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kKind = "striate short-term memory";  // first words of the file: what it is
constexpr double kMoves = 0.5;  // share of a column that moved, as MotionSettings::least_share
constexpr std::size_t kCommandsShown = 10;  // a second of commands

/// JSON has no infinity: what is not known is null.
Json known(Json json) {
  if (json.is_number_float() && !std::isfinite(json.get<double>())) return nullptr;
  if (json.is_structured()) {
    for (Json& inner : json) inner = known(std::move(inner));
  }
  return json;
}

char letter_of(const memory::PolarMap::Cell& cell) {
  if (cell.state == memory::CellState::occupied) return cell.moving > kMoves ? 'o' : '#';
  return cell.state == memory::CellState::free ? '.' : ' ';
}

Json polar_map(const memory::ShortTermMemory& memory) {
  const memory::PolarMap map = memory.polar_map();
  Json rings = Json::array();
  for (int ring = 0; ring < memory::PolarMap::kRings; ++ring) {
    std::string sectors;
    for (int k = 0; k < memory::PolarMap::kSectors; ++k) {
      const int sector = (memory::PolarMap::kSectors / 2 - k + memory::PolarMap::kSectors) %
                         memory::PolarMap::kSectors;
      sectors += letter_of(map.at(sector, ring));
    }
    rings.push_back({{"to_m", memory::PolarMap::ring_outer_m(ring)}, {"sectors", sectors}});
  }
  return rings;
}

Json commands(const memory::ShortTermMemory& memory, std::uint64_t cycles) {
  Json list = Json::array();
  for (std::size_t back = 0; back < std::min<std::uint64_t>(kCommandsShown, cycles); ++back) {
    const memory::ShortTermMemory::SentCommand& one = memory.sent(back);
    list.push_back({{"time_s", to_seconds(one.stamp)},
                    {"forward_m_s", one.command.forward_m_s},
                    {"turn_rad_s", one.command.turn_rad_s},
                    {"pan_rad", one.command.pan_rad},
                    {"tilt_rad", one.command.tilt_rad},
                    {"action", one.doing.view()}});
  }
  return list;
}

}  // namespace

nlohmann::ordered_json corridor_state(const memory::ShortTermMemory& memory) {
  const memory::CorridorMemory& corridor = memory.corridor();
  return {{"axis_rad", wrap_angle(corridor.axis_rad() - memory.pose().heading_rad)},
          {"offset_left_m", corridor.offset_m()},
          {"width_m", corridor.width_m()},
          {"width_known", corridor.width_known()},
          {"left_wall_m", corridor.left_m()},
          {"right_wall_m", corridor.right_m()},
          {"progress_m", corridor.progress_m()}};
}

nlohmann::ordered_json salient_regions_state(const memory::ShortTermMemory& memory) {
  Json list = Json::array();
  for (const memory::RememberedRegion& one : memory.salient().regions()) {
    if (!one.used) continue;
    list.push_back({{"id", one.id},
                    {"bearing_rad", one.bearing_rad},
                    {"distance_m", one.distance_m},
                    {"size_rad", one.size_rad},
                    {"salience", one.salience},
                    {"hits", one.hits},
                    {"activation", one.activation},
                    {"seen_s_ago", to_seconds(memory.now() - one.last_seen)},
                    {"inhibited", one.inhibited_until > memory.now()}});
  }
  return list;
}

nlohmann::ordered_json landmarks_state(const memory::ShortTermMemory& memory) {
  Json list = Json::array();
  for (const memory::LandmarkInMind& one : memory.landmarks().all()) {
    if (one.landmark == 0) continue;
    const Point2 place = inverse_transform(memory.pose(), one.place);
    list.push_back(
        {{"name", one.name.view()},
         {"sightings", one.sightings},
         {"confirmed", one.confirmed},
         {"score", one.score},
         {"bearing_rad", one.bearing_rad},
         {"distance_m", one.place_known ? Json(std::hypot(place.x_m, place.y_m)) : Json(nullptr)},
         {"sigma_m", one.place_known ? Json(one.place_sigma_m) : Json(nullptr)},
         {"seen_s_ago",
          one.sightings > 0 ? Json(to_seconds(memory.now() - one.last_seen)) : Json(nullptr)}});
  }
  return list;
}

nlohmann::ordered_json memory_state(const CognitiveCycle& cycle, const tasks::Executive& executive,
                                    std::uint64_t number) {
  const memory::ShortTermMemory& memory = cycle.memory();
  const CycleTrace& trace = cycle.trace();
  return {{"kind", kKind},
          {"cycle", number},
          {"time_s", to_seconds(memory.now())},
          {"action", std::string(executive.current_action())},
          {"why", std::string(trace.wish.why.view())},
          {"limited_by", name_of(trace.limited_by)},
          {"pose",
           {{"x_m", memory.pose().x_m},
            {"y_m", memory.pose().y_m},
            {"heading_rad", memory.pose().heading_rad},
            {"forward_m_s", memory.forward_m_s()},
            {"turn_rad_s", memory.turn_rad_s()},
            {"pan_rad", memory.head().pan_rad},
            {"tilt_rad", memory.head().tilt_rad}}},
          {"picture",
           {{"age_s", known(memory.image_age_s())},
            {"light_level", memory.light_level()},
            {"noise_level", memory.noise_level()},
            {"seen_share", memory.seen_share()}}},
          {"corridor", known(corridor_state(memory))},
          {"polar_map", polar_map(memory)},
          {"salient_regions", known(salient_regions_state(memory))},
          {"landmarks", known(landmarks_state(memory))},
          {"commands", commands(memory, number)}};
}

nlohmann::ordered_json read_memory_state(const std::string& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw UserError(fmt::format("{}: cannot be read\n    is the path right?", file));
  Json state = Json::parse(stream, nullptr, false);
  if (!state.is_object() || state.value("kind", Json()) != kKind) {
    throw UserError(fmt::format(
        "{}: is neither a recording (striate run --record) nor the memory of a running mission\n"
        "    (striate run --inspect)",
        file));
  }
  return state;
}

}  // namespace striate::agent
