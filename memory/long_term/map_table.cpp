#include "striate/memory/long_term/map_table.hpp"

#include <algorithm>

#include "striate/memory/long_term/statement_use.hpp"

namespace striate::memory {
namespace {

constexpr double kMostLogOdds = 20.0;  ///< the bound that schema.cpp gives the table

}  // namespace

MapTable::MapTable(SQLite::Database& database)
    : put_route_(database,
                 "INSERT OR REPLACE INTO route SELECT ?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8 "
                 "WHERE EXISTS (SELECT 1 FROM landmark WHERE id = ?1) "
                 "AND EXISTS (SELECT 1 FROM landmark WHERE id = ?2)"),
      routes_(database,
              "SELECT from_landmark, to_landmark, distance_m, turn_rad, distance_var_m2, "
              "turn_var_rad2, successes, failures FROM route ORDER BY 1, 2"),
      put_cell_(database, "INSERT OR REPLACE INTO obstacle_cell VALUES (?, ?, ?, ?)"),
      cells_(database,
             "SELECT cell_row, cell_column, log_odds, seen_s FROM obstacle_cell ORDER BY 1, 2") {}

void MapTable::put(const Route& route) {
  StatementUse use(put_route_);
  use.with(route.from).with(route.to).with(route.distance_m).with(route.turn_rad);
  use.with(route.distance_var_m2).with(route.turn_var_rad2);
  use.with(route.successes).with(route.failures).run();
}

std::vector<Route> MapTable::routes() {
  StatementUse use(routes_);
  std::vector<Route> routes;
  while (use.next()) {
    routes.push_back({use.column(0).getInt64(), use.column(1).getInt64(), use.column(2).getDouble(),
                      use.column(3).getDouble(), use.column(4).getDouble(),
                      use.column(5).getDouble(), use.count(6), use.count(7)});
  }
  return routes;
}

void MapTable::put(const ObstacleCell& cell) {
  StatementUse use(put_cell_);
  use.with(cell.row).with(cell.column);
  use.with(std::clamp(cell.log_odds, -kMostLogOdds, kMostLogOdds)).with(cell.seen_s).run();
}

std::vector<ObstacleCell> MapTable::cells() {
  StatementUse use(cells_);
  std::vector<ObstacleCell> cells;
  while (use.next()) {
    ObstacleCell cell;
    cell.row = use.column(0).getInt();
    cell.column = use.column(1).getInt();
    cell.log_odds = use.column(2).getDouble();
    cell.seen_s = use.column(3).getDouble();
    cells.push_back(cell);
  }
  return cells;
}

}  // namespace striate::memory
