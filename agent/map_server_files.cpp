#include "striate/agent/map_server_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "striate/base/user_error.hpp"

namespace striate::agent {
namespace {

// How map_server reads a picture in its mode "trinary", with the thresholds of its own maps.
constexpr double kOccupied = 0.65;        // probability from which a cell is occupied
constexpr double kFree = 0.196;           // probability up to which a cell is free
constexpr char kOccupiedGrey = '\0';      // grey level of 255
constexpr char kFreeGrey = '\xfe';        // grey level 254 of 255
constexpr char kUnknownGrey = '\xcd';     // grey level 205 of 255
constexpr std::int64_t kMostSide = 8000;  // cells: 800 m, a picture of 64 MB at most (ours)

char grey_of(double log_odds) {
  const double occupied = 1.0 / (1.0 + std::exp(-log_odds));
  if (occupied >= kOccupied) return kOccupiedGrey;
  return occupied <= kFree ? kFreeGrey : kUnknownGrey;
}

}  // namespace

MapServerFiles map_server_files(const std::vector<memory::ObstacleCell>& cells,
                                const std::string& image) {
  if (cells.empty()) throw UserError("the memory has no map yet: no cell of its grid is known");
  const auto [left, right] = std::ranges::minmax(cells, {}, &memory::ObstacleCell::column);
  const auto [bottom, top] = std::ranges::minmax(cells, {}, &memory::ObstacleCell::row);
  const std::int64_t columns = std::int64_t{right.column} - left.column + 1;
  const std::int64_t rows = std::int64_t{top.row} - bottom.row + 1;
  if (columns > kMostSide || rows > kMostSide) {
    throw UserError(
        fmt::format("the map is {} x {} cells: more than {} a side", columns, rows, kMostSide));
  }
  MapServerFiles files;
  files.pgm = fmt::format("P5\n{} {}\n255\n", columns, rows);
  const std::size_t header = files.pgm.size();
  files.pgm.append(static_cast<std::size_t>(columns * rows), kUnknownGrey);
  for (const memory::ObstacleCell& cell : cells) {
    const std::int64_t down = std::int64_t{top.row} - cell.row;
    const std::int64_t across = std::int64_t{cell.column} - left.column;
    files.pgm[header + static_cast<std::size_t>(down * columns + across)] = grey_of(cell.log_odds);
  }
  // The origin is the outer corner of the bottom left cell.
  files.yaml = fmt::format(
      "image: {}\nmode: trinary\nresolution: {:.3f}\norigin: [{:.3f}, {:.3f}, 0.0]\nnegate: 0\n"
      "occupied_thresh: {}\nfree_thresh: {}\n",
      image, memory::kObstacleCell_m, left.column * memory::kObstacleCell_m,
      bottom.row * memory::kObstacleCell_m, kOccupied, kFree);
  return files;
}

}  // namespace striate::agent
