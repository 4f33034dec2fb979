#include "app/memory/landmark_knowledge.hpp"

#include <algorithm>
#include <filesystem>
#include <unordered_map>
#include <utility>

#include "app/memory/open_memory.hpp"
#include "memory/long_term/view_codec.hpp"
#include "memory/place/place_keeping.hpp"

namespace striate {
namespace {

LandmarkView view_to_look_for(const StoredView& stored) {
  LandmarkView view;
  view.width_px = stored.width_px;
  view.height_px = stored.height_px;
  for (const StoredDescriptor& descriptor : stored.descriptors) {
    view.descriptors.push_back(descriptor_of(descriptor));
  }
  for (const StoredKeypoint& point : stored.keypoints) {
    view.keypoints.push_back({point.x_px, point.y_px, point.size_px, point.angle_rad});
  }
  return view;
}

/// A size that is not above 0 can come in by import only; the recogniser refuses it.
bool is_sound(const StoredView& view) {
  if (view.damaged || view.descriptors.size() != view.keypoints.size()) return false;
  return std::ranges::all_of(view.keypoints,
                             [](const StoredKeypoint& point) { return point.size_px > 0.0F; });
}

void read(MemoryTables& tables, LandmarkKnowledge& knowledge) {
  std::unordered_map<std::int64_t, std::size_t> place;
  for (Landmark& landmark : tables.landmarks.all(false)) {
    place[landmark.id] = knowledge.landmarks.size();
    knowledge.landmarks.push_back({std::move(landmark), {}});
  }
  tables.views.for_each([&](const StoredView& stored) {
    const auto known = place.find(stored.landmark);
    if (known == place.end() || !is_sound(stored)) return;
    knowledge.landmarks[known->second].views.push_back(view_to_look_for(stored));
  });
  knowledge.routes = tables.places.routes();
  knowledge.operating_start_s = tables.sessions.operating_now_s();
}

}  // namespace

LandmarkKnowledge read_landmark_knowledge(const std::string& memory) {
  LandmarkKnowledge knowledge;
  if (memory.empty() || !std::filesystem::exists(memory)) return knowledge;
  with_memory(memory, Access::read, "looking up its landmarks",
              [&](MemoryTables& tables, MemoryFile&) { read(tables, knowledge); });
  return knowledge;
}

MissionKnowledge read_mission_knowledge(const std::string& memory) {
  MissionKnowledge knowledge{read_landmark_knowledge(memory), PlaceKnowledge{}};
  if (memory.empty() || !std::filesystem::exists(memory)) return knowledge;
  with_memory(memory, Access::read, "looking up its places",
              [&](MemoryTables& tables, MemoryFile&) { knowledge.places = read_places(tables); });
  return knowledge;
}

}  // namespace striate
