/// How far off the robot believes to be after round trips of 120 m, with memory and without:
/// medians over seeds, in a made corridor (tests/reference/localisation_trips.hpp).
///
///     build/release/place_table [SEEDS]
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "tests/reference/localisation_trips.hpp"

namespace {

using striate::reference::TripDriver;
using striate::reference::TripResult;
using striate::reference::TripSettings;

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

struct Case {
  const char* name;
  TripSettings trip;
  int missions = 3;
  int trips_each = 1;
  bool starts_at_home = true;
};

void print(const Case& one, int seeds) {
  std::vector<std::vector<TripResult>> results(static_cast<std::size_t>(one.missions));
  for (int seed = 1; seed <= seeds; ++seed) {
    striate::memory::LocalisationSettings place;
    place.starts_at_home = one.starts_at_home;
    TripDriver driver(one.trip, place, static_cast<std::uint64_t>(seed));
    for (auto& mission : results) mission.push_back(driver.drive(one.trips_each));
  }
  for (std::size_t mission = 0; mission < results.size(); ++mission) {
    std::vector<double> odometry, memory, share;
    double nees = 0.0;
    int located = 0, taken = 0, rejected = 0;
    for (const TripResult& result : results[mission]) {
      odometry.push_back(result.odometry_error_m);
      memory.push_back(result.memory_error_m);
      share.push_back(result.memory_error_m / result.odometry_error_m);
      nees += result.nees / seeds;
      located += result.located ? 1 : 0;
      taken += result.taken;
      rejected += result.rejected;
    }
    fmt::print("{:30} {:7} {:9.2f} {:7.3f} {:7.3f} {:7.3f} {:7.2f} {:8} {:6} {:6}\n", one.name,
               mission + 1, quantile(odometry, 0.5), quantile(memory, 0.5), quantile(memory, 0.95),
               quantile(share, 0.5), nees, located, taken / seeds, rejected / seeds);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::max(1, std::atoi(argv[1])) : 40;
  fmt::print("{:30} {:>7} {:>9} {:>7} {:>7} {:>7} {:>7} {:>8} {:>6} {:>6}\n", "case", "mission",
             "odometry", "memory", "95 %", "share", "NEES", "located", "taken", "reject");
  TripSettings exact;
  exact.wrong_share = 0.0;
  exact.middle_error_m = 0.0;
  TripSettings one_way;
  one_way.seen_from_behind = false;
  TripSettings sparse;
  sparse.spacing_m = 12.0;
  TripSettings often_wrong;
  often_wrong.wrong_share = 0.2;
  TripSettings anywhere;
  anywhere.start_error_m = 3.0;
  anywhere.start_error_rad = 0.0;
  for (const Case& one : std::vector<Case>{{"3 missions", {}},
                                           {"3 trips in one mission", {}, 1, 3},
                                           {"exact sightings", exact},
                                           {"recognised on the way out only", one_way},
                                           {"a landmark each 12 m", sparse},
                                           {"every 5th sighting wrong", often_wrong},
                                           {"later starts 3 m elsewhere", anywhere, 3, 1, false}}) {
    print(one, seeds);
  }
}
