#include "striate/memory/localisation/map_keeping.hpp"

namespace striate::memory {

MapKnowledge read_map(MemoryTables& tables) {
  return {tables.landmarks.all(false), tables.places.routes(), tables.places.cells()};
}

void keep_map(MemoryTables& tables, const MapNews& news) {
  for (const MapNews::Position& one : news.positions) {
    tables.landmarks.set_position(one.landmark, one.at);
  }
  for (const Route& route : news.routes) tables.places.put(route);
  for (const ObstacleCell& cell : news.cells) tables.places.put(cell);
}

}  // namespace striate::memory
