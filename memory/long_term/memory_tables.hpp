#pragma once

#include "memory/long_term/landmark_table.hpp"
#include "memory/long_term/place_table.hpp"
#include "memory/long_term/session_table.hpp"
#include "memory/long_term/view_table.hpp"

namespace striate {

/// All tables of an opened memory, with every statement prepared once. Belongs to one thread.
struct MemoryTables {
  explicit MemoryTables(SQLite::Database& database)
      : landmarks(database), views(database), sessions(database), places(database) {}

  LandmarkTable landmarks;
  ViewTable views;
  SessionTable sessions;
  PlaceTable places;
};

}  // namespace striate
