#pragma once

#include <string>
#include <vector>

#include "app/cognitive_cycle.hpp"
#include "memory/familiar_landmarks.hpp"
#include "memory/place/place_memory.hpp"
#include "tasks/task.hpp"

namespace striate {

/// Reads the landmarks of a memory with their sound views and the routes between them, once, at the
/// start of a mission. Nothing where the file is still to be made.
/// @throws UserError as MemoryFile does
[[nodiscard]] LandmarkKnowledge read_landmark_knowledge(const std::string& memory);

/// What a memory tells a mission before it starts.
struct MissionKnowledge {
  LandmarkKnowledge landmarks;
  PlaceKnowledge places;

  /// For the task's `needs: {landmarks: ...}`.
  [[nodiscard]] std::vector<std::string> names() const;
};

/// Reads all of it. Nothing where the file is still to be made. @throws UserError as MemoryFile
/// does
[[nodiscard]] MissionKnowledge read_mission_knowledge(const std::string& memory);

/// Tells the mind what is known; the landmark that the task needs first comes to mind first.
void hand_over(MissionKnowledge knowledge, const Task& task, const LongTermSettings& settings,
               CognitiveCycle& cycle);

}  // namespace striate
