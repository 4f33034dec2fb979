#pragma once

#include <string>

#include "striate/agent/cognitive_cycle.hpp"
#include "striate/memory/long_term/memory_tables.hpp"
#include "striate/memory/short_term/familiar_landmarks.hpp"

namespace striate::agent {

/// The landmarks of an open memory with their sound views, and the routes between them.
[[nodiscard]] memory::LandmarkKnowledge landmark_knowledge_of(memory::MemoryTables& tables);

/// The same of a memory's file, once, at the start of a mission. Nothing where the file is still to
/// be made.
/// @throws UserError as MemoryFile does
[[nodiscard]] memory::LandmarkKnowledge read_landmark_knowledge(const std::string& memory);

/// Reads all that a memory tells a mission. Nothing where the file is still to be made. @throws
/// UserError as MemoryFile does
[[nodiscard]] MissionKnowledge read_mission_knowledge(const std::string& memory);

}  // namespace striate::agent
