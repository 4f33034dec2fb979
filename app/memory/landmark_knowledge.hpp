#pragma once

#include <string>

#include "memory/familiar_landmarks.hpp"
#include "memory/place/place_memory.hpp"

namespace striate {

/// Reads the landmarks of a memory with their sound views and the routes between them, once, at the
/// start of a mission. Nothing where the file is still to be made.
/// @throws UserError as MemoryFile does
[[nodiscard]] LandmarkKnowledge read_landmark_knowledge(const std::string& memory);

/// Reads what a memory knows of places, likewise.
[[nodiscard]] PlaceKnowledge read_place_knowledge(const std::string& memory);

}  // namespace striate
