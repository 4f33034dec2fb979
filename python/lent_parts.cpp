#include "striate/python/lent_parts.hpp"

#include <opencv2/core.hpp>

#include "striate/python/arrays.hpp"

namespace striate::python {

using memory::LocalGrid;
using memory::PolarMap;

py::dict polar_of(const LentMemory& lent) {
  const PolarMap map = lent.get().polar_map();
  cv::Mat1b state(PolarMap::kSectors, PolarMap::kRings);
  cv::Mat1f log_odds(state.size());
  cv::Mat1f age_s(state.size());
  cv::Mat1f moving(state.size());
  cv::Mat1f to_m(1, PolarMap::kRings);
  cv::Mat1f bearing_rad(1, PolarMap::kSectors);
  for (int sector = 0; sector < PolarMap::kSectors; ++sector) {
    bearing_rad(0, sector) = static_cast<float>(PolarMap::sector_bearing_rad(sector));
    for (int ring = 0; ring < PolarMap::kRings; ++ring) {
      const PolarMap::Cell& cell = map.at(sector, ring);
      state(sector, ring) = static_cast<std::uint8_t>(cell.state);
      log_odds(sector, ring) = cell.log_odds;
      age_s(sector, ring) = cell.age_s;
      moving(sector, ring) = cell.moving;
      to_m(0, ring) = static_cast<float>(PolarMap::ring_outer_m(ring));
    }
  }
  py::dict dict;
  dict["state"] = array_of(state);
  dict["log_odds"] = array_of(log_odds);
  dict["age_s"] = array_of(age_s);
  dict["moving"] = array_of(moving);
  dict["to_m"] = array_of(to_m).attr("reshape")(-1);
  dict["bearing_rad"] = array_of(bearing_rad).attr("reshape")(-1);
  return dict;
}

py::array grid_of(const LentMemory& lent) {
  const LocalGrid& grid = lent.get().map();
  const memory::GridCell first = grid.first();
  cv::Mat1f log_odds(LocalGrid::kSide, LocalGrid::kSide);
  for (int y = 0; y < LocalGrid::kSide; ++y) {
    for (int x = 0; x < LocalGrid::kSide; ++x) {
      log_odds(y, x) = grid.log_odds({first.x + x, first.y + y});
    }
  }
  return array_of(log_odds);
}

py::array trajectory_of(const LentMemory& lent) {
  const memory::Trajectory& trajectory = lent.get().trajectory();
  cv::Mat1d places(static_cast<int>(trajectory.count()), 2);
  for (int i = 0; i < places.rows; ++i) {
    const Point2 place = trajectory.at(static_cast<std::size_t>(i));
    places(i, 0) = place.x_m;
    places(i, 1) = place.y_m;
  }
  return array_of(places);
}

}  // namespace striate::python
