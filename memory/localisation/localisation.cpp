#include "striate/memory/localisation/localisation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace striate::memory {
namespace {

// "By hand": memory/README.md, "Where the numbers come from".

constexpr std::size_t kMostRecalled = 48;     ///< by hand, of the 64 of LandmarkMemory::kCapacity
constexpr std::size_t kMostCellsTold = 4096;  ///< by hand: of one cycle; the rest in the next ones
constexpr float kSays = 0.5F;  ///< log-odds below which a cell says nothing: LocalGrid::kFreeBelow
constexpr float kStands = 0.5F;  ///< weight of one of the four small cells that make a large one
constexpr float kFree = 0.25F;   ///< the same of floor: four small cells make one look at all of it
constexpr double kAhead_rad = 1.2;  ///< by hand, 69 degrees: what lies more aside is not ahead

double sigma_of(const MapPosition& place) {
  const double mean = (place.var_x_m2 + place.var_y_m2) / 2.0;
  const double half = (place.var_x_m2 - place.var_y_m2) / 2.0;
  return std::sqrt(std::max(0.0, mean + std::hypot(half, place.cov_xy_m2)));
}

double distance2_m2(const MapPosition& place, const Pose2& from) {
  const double dx = place.x_m - from.x_m;
  const double dy = place.y_m - from.y_m;
  return dx * dx + dy * dy;
}

}  // namespace

Localisation::Localisation(const LocalisationSettings& settings)
    : estimate_(settings), learner_(settings) {}

void Localisation::know(const MapKnowledge& knowledge) {
  for (const Landmark& landmark : knowledge.landmarks) {
    estimate_.know(landmark.id, landmark.position);
    names_.push_back({landmark.id, landmark.name});
  }
  routes_.know(knowledge.routes);
  obstacles_.start();
  for (const ObstacleCell& cell : knowledge.cells) obstacles_.know(cell);
  learner_.start(knowledge.landmarks.size());
  passed_now_.reserve(knowledge.landmarks.size());
  near_.reserve(knowledge.landmarks.size());
  active_ = true;
}

void Localisation::move(const Pose2& odometry) {
  if (!active_) return;
  if (!started_) {
    started_ = true;
    estimate_.start(odometry);
    return;
  }
  estimate_.move(odometry);
  learner_.move(estimate_, passed_now_);
  for (const Station& station : passed_now_) pass(station);
}

SightingVerdict Localisation::see(const LandmarkSighting& sighting, const Pose2& at) {
  return active_ && started_ ? estimate_.see(sighting, at) : SightingVerdict::no_room;
}

void Localisation::pass(const Station& station) {
  if (last_.landmark != 0 && last_.landmark != station.landmark && station.way_m > last_.way_m) {
    routes_.driven(last_.landmark, station.landmark, station.way_m - last_.way_m,
                   wrap_angle(station.heading_rad - last_.heading_rad));
  }
  last_ = station;
}

void Localisation::keep_leaving(const LocalGrid& grid, Point2 next) {
  if (!located()) return;
  const GridCell now = grid.first();
  const GridCell then = LocalGrid::first_around(next);
  const int side = LocalGrid::kSide;
  const int left = std::clamp(then.x - now.x, 0, side);
  const int right = std::clamp(now.x - then.x, 0, side);
  const int low = std::clamp(then.y - now.y, 0, side);
  const int high = std::clamp(now.y - then.y, 0, side);
  keep(grid, now, {now.x + left, now.y + side});
  keep(grid, {now.x + side - right, now.y}, {now.x + side, now.y + side});
  keep(grid, {now.x + left, now.y}, {now.x + side - right, now.y + low});
  keep(grid, {now.x + left, now.y + side - high}, {now.x + side - right, now.y + side});
}

void Localisation::keep_all(const LocalGrid& grid) {
  const GridCell first = grid.first();
  if (located()) keep(grid, first, {first.x + LocalGrid::kSide, first.y + LocalGrid::kSide});
}

/// Four small cells make a large one: one that stands among them outweighs the floor round it.
void Localisation::keep(const LocalGrid& grid, GridCell first, GridCell beyond) {
  const Pose2 from_odometry = estimate_.from_odometry();
  for (int y = first.y; y < beyond.y; ++y) {
    for (int x = first.x; x < beyond.x; ++x) {
      const float evidence = grid.log_odds({x, y}) * (1.0F - grid.moving({x, y}));
      if (std::abs(evidence) < kSays) continue;
      obstacles_.add(transform(from_odometry, LocalGrid::centre_of({x, y})),
                     evidence * (evidence > 0.0F ? kStands : kFree));
    }
  }
}

/// Whither the robot was under way nobody says: to the landmark that a driven stretch leads to and
/// that lies most nearly ahead.
void Localisation::fail() {
  if (!active_ || last_.landmark == 0) return;
  const Pose2 pose = estimate_.pose();
  double least_rad = kAhead_rad;
  std::int64_t to = 0;
  for (const Route& route : routes_.all()) {
    const std::optional<MapPosition> place = estimate_.place(route.to);
    if (route.from != last_.landmark || !place) continue;
    const Point2 here = inverse_transform(pose, Point2{place->x_m, place->y_m});
    const double off_rad = std::abs(std::atan2(here.y_m, here.x_m));
    if (off_rad >= least_rad) continue;
    least_rad = off_rad;
    to = route.to;
  }
  if (to != 0) routes_.failed(last_.landmark, to);
}

/// Of more than short-term memory holds, the nearest.
void Localisation::recall_into(LandmarkMemory& landmarks) {
  if (!active_ || !started_) return;
  near_.clear();
  const Pose2 pose = estimate_.pose();
  const auto all = estimate_.landmarks();
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::optional<MapPosition> place = estimate_.place_from_robot(all[k]);
    if (place) near_.push_back({distance2_m2(*place, pose), k});
  }
  if (near_.size() > kMostRecalled) {
    std::nth_element(near_.begin(), near_.begin() + kMostRecalled, near_.end(),
                     [](const Near& a, const Near& b) { return a.distance2_m2 < b.distance2_m2; });
    near_.resize(kMostRecalled);
  }
  const Pose2 from_odometry = estimate_.from_odometry();
  for (const Near& near : near_) {
    const MapPosition place = *estimate_.place_from_robot(all[near.landmark]);
    landmarks.recall(all[near.landmark].landmark, names_[near.landmark].name,
                     inverse_transform(from_odometry, Point2{place.x_m, place.y_m}),
                     sigma_of(place));
  }
}

Pose2 Localisation::start() const {
  if (!active_ || !started_) return {};
  return inverse_transform(estimate_.from_odometry(), estimate_.start());
}

std::int64_t Localisation::nearest_station(const Pose2& to) const {
  std::int64_t nearest = 0;
  double least_m2 = std::numeric_limits<double>::infinity();
  for (const MappedLandmark& one : estimate_.landmarks()) {
    const std::optional<MapPosition> place = estimate_.place_from_robot(one);
    if (!place || !routes_.has(one.landmark) || distance2_m2(*place, to) >= least_m2) continue;
    least_m2 = distance2_m2(*place, to);
    nearest = one.landmark;
  }
  return nearest;
}

std::int64_t Localisation::last_station() const {
  if (!active_ || !started_) return 0;
  return last_.landmark != 0 ? last_.landmark : nearest_station(estimate_.pose());
}

RoutePlan Localisation::path_to(std::int64_t landmark) const {
  return routes_.path_to(last_station(), landmark);
}

RoutePlan Localisation::path_home() const {
  if (!active_ || !started_) return {};
  return routes_.path_to(last_station(), nearest_station(estimate_.start()));
}

MapNews Localisation::take_news(double operating_s) {
  MapNews news;
  if (!active_) return news;
  estimate_.tell_news([&](std::int64_t landmark, const MapPosition& at) {
    news.positions.push_back({landmark, at});
  });
  routes_.take_changed([&](const Route& route) { news.routes.push_back(route); });
  obstacles_.take_changed(kMostCellsTold, [&](int column, int row, float log_odds) {
    news.cells.push_back({column, row, log_odds, operating_s});
  });
  return news;
}

}  // namespace striate::memory
