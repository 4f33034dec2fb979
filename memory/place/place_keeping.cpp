#include "memory/place/place_keeping.hpp"

namespace striate {

PlaceKnowledge read_places(MemoryTables& tables) {
  return {tables.landmarks.all(false), tables.places.routes(), tables.places.cells()};
}

void keep_places(MemoryTables& tables, const PlaceNews& news) {
  for (const PlaceNews::Position& one : news.positions) {
    tables.landmarks.set_position(one.landmark, one.at);
  }
  for (const Route& route : news.routes) tables.places.put(route);
  for (const ObstacleCell& cell : news.cells) tables.places.put(cell);
}

}  // namespace striate
