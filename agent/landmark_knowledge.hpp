#pragma once

#include <string>

#include "striate/agent/cognitive_cycle.hpp"
#include "striate/memory/short_term/familiar_landmarks.hpp"

namespace striate::agent {

/// Reads the landmarks of a memory with their sound views and the routes between them, once, at the
/// start of a mission. Nothing where the file is still to be made.
/// @throws UserError as MemoryFile does
[[nodiscard]] memory::LandmarkKnowledge read_landmark_knowledge(const std::string& memory);

/// Reads all that a memory tells a mission. Nothing where the file is still to be made. @throws
/// UserError as MemoryFile does
[[nodiscard]] MissionKnowledge read_mission_knowledge(const std::string& memory);

}  // namespace striate::agent
