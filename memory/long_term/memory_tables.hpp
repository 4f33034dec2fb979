#pragma once

#include "striate/memory/long_term/landmark_table.hpp"
#include "striate/memory/long_term/map_table.hpp"
#include "striate/memory/long_term/session_table.hpp"
#include "striate/memory/long_term/view_table.hpp"

namespace striate::memory {

/// All tables of an opened memory, with every statement prepared once. Belongs to one thread.
struct MemoryTables {
  explicit MemoryTables(SQLite::Database& database)
      : landmarks(database), views(database), sessions(database), places(database) {}

  LandmarkTable landmarks;
  ViewTable views;
  SessionTable sessions;
  MapTable places;
};

}  // namespace striate::memory
