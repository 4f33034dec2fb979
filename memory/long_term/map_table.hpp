#pragma once

#include <SQLiteCpp/Database.h>
#include <SQLiteCpp/Statement.h>

#include <vector>

#include "striate/memory/long_term/records.hpp"

namespace striate::memory {

/// The tables `route` and `obstacle_cell`. All errors are SQLite::Exception.
class MapTable {
 public:
  explicit MapTable(SQLite::Database& database);

  /// Adds it, or puts it in the place of the one between the same landmarks. Nothing where one of
  /// them is no more.
  void put(const Route& route);
  [[nodiscard]] std::vector<Route> routes();
  /// Adds it, or puts it in the place of the old one.
  void put(const ObstacleCell& cell);
  /// By row, then column.
  [[nodiscard]] std::vector<ObstacleCell> cells();

 private:
  SQLite::Statement put_route_, routes_, put_cell_, cells_;
};

}  // namespace striate::memory
