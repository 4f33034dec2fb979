#include "striate/agent/landmark_knowledge.hpp"

#include <algorithm>
#include <filesystem>
#include <unordered_map>
#include <utility>

#include "striate/agent/open_memory.hpp"
#include "striate/memory/localisation/map_keeping.hpp"
#include "striate/memory/long_term/view_codec.hpp"

namespace striate::agent {
namespace {

perception::LandmarkView view_to_look_for(const memory::StoredView& stored) {
  perception::LandmarkView view;
  view.width_px = stored.width_px;
  view.height_px = stored.height_px;
  for (const memory::StoredDescriptor& descriptor : stored.descriptors) {
    view.descriptors.push_back(memory::descriptor_of(descriptor));
  }
  for (const perception::ViewKeypoint& point : stored.keypoints) {
    view.keypoints.push_back({point.x_px, point.y_px, point.size_px, point.angle_rad});
  }
  return view;
}

/// A size that is not above 0 can come in by import only; the recogniser refuses it.
bool is_sound(const memory::StoredView& view) {
  if (view.damaged || view.descriptors.size() != view.keypoints.size()) return false;
  return std::ranges::all_of(
      view.keypoints, [](const perception::ViewKeypoint& point) { return point.size_px > 0.0F; });
}

}  // namespace

memory::LandmarkKnowledge landmark_knowledge_of(memory::MemoryTables& tables) {
  memory::LandmarkKnowledge knowledge;
  std::unordered_map<std::int64_t, std::size_t> place;
  for (memory::Landmark& landmark : tables.landmarks.all(false)) {
    place[landmark.id] = knowledge.landmarks.size();
    knowledge.landmarks.push_back({std::move(landmark), {}});
  }
  tables.views.for_each([&](const memory::StoredView& stored) {
    const auto known = place.find(stored.landmark);
    if (known == place.end() || !is_sound(stored)) return;
    knowledge.landmarks[known->second].views.push_back(view_to_look_for(stored));
  });
  knowledge.routes = tables.places.routes();
  knowledge.operating_start_s = tables.sessions.operating_now_s();
  return knowledge;
}

memory::LandmarkKnowledge read_landmark_knowledge(const std::string& memory) {
  memory::LandmarkKnowledge knowledge;
  if (memory.empty() || !std::filesystem::exists(memory)) return knowledge;
  with_memory(memory, memory::Access::read, "looking up its landmarks",
              [&](memory::MemoryTables& tables, memory::MemoryFile&) {
                knowledge = landmark_knowledge_of(tables);
              });
  return knowledge;
}

MissionKnowledge read_mission_knowledge(const std::string& memory) {
  MissionKnowledge knowledge{read_landmark_knowledge(memory), memory::MapKnowledge{}};
  if (memory.empty() || !std::filesystem::exists(memory)) return knowledge;
  with_memory(memory, memory::Access::read, "looking up its places",
              [&](memory::MemoryTables& tables, memory::MemoryFile&) {
                knowledge.places = memory::read_map(tables);
              });
  return knowledge;
}

}  // namespace striate::agent
