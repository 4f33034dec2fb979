#include "striate/platform/simulator/random_world/random_world.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "striate/platform/simulator/obstacle_shapes.hpp"
#include "striate/platform/simulator/random_world/building_style.hpp"
#include "striate/platform/simulator/world_reader.hpp"
#include "striate/platform/simulator/world_writer.hpp"

namespace striate::simulator {
namespace {

constexpr std::uint64_t kSeedsOfAKind = 300;

BuildingKind building_of(std::size_t kind) {
  return static_cast<BuildingKind>(kind);
}

/// All that the tests look at, drawn once.
const std::vector<std::vector<RandomWorld>>& drawn_buildings() {
  static const std::vector<std::vector<RandomWorld>> all = [] {
    std::vector<std::vector<RandomWorld>> kinds(building_kinds().size());
    for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
      for (std::uint64_t seed = 1; seed <= kSeedsOfAKind; ++seed) {
        kinds[kind].push_back(draw_random_world(building_of(kind), seed));
      }
    }
    return kinds;
  }();
  return all;
}

template <class Visit>
void each_building(Visit visit) {
  for (const auto& kind : drawn_buildings()) {
    for (const RandomWorld& drawn : kind) visit(drawn);
  }
}

bool has_difficulty(const RandomWorld& drawn, Difficulty difficulty) {
  return std::find(drawn.difficulties.begin(), drawn.difficulties.end(), difficulty) !=
         drawn.difficulties.end();
}

TEST(RandomWorlds, AreReadBackWithoutAWord) {
  each_building([](const RandomWorld& drawn) {
    config::Diagnostics diagnostics(drawn.world.name);
    const World world = parse_world(drawn.yaml, diagnostics);
    EXPECT_TRUE(diagnostics.text().empty()) << diagnostics.text();
    EXPECT_EQ(world_as_yaml(world), world_as_yaml(drawn.world)) << drawn.world.name;
  });
}

TEST(RandomWorlds, HaveAWayThatTheRobotFitsIn) {
  each_building([](const RandomWorld& drawn) {
    const Passage passage = widest_passage(drawn.world, build_floor_plan(drawn.world));
    EXPECT_GE(passage.width_m, kDrivable_m) << drawn.world.name;
    EXPECT_LE(drawn.proposals, 20) << drawn.world.name;
  });
}

TEST(RandomWorlds, HaveEachDifficultyAsOftenAsTheirKindSays) {
  for (std::size_t kind = 0; kind < drawn_buildings().size(); ++kind) {
    const BuildingStyle& style = style_of(building_of(kind));
    for (int i = 0; i < kDifficulties; ++i) {
      const auto count = std::count_if(
          drawn_buildings()[kind].begin(), drawn_buildings()[kind].end(),
          [&](const RandomWorld& d) { return has_difficulty(d, static_cast<Difficulty>(i)); });
      const double share = style.share_percent[static_cast<std::size_t>(i)] / 100.0;
      const double expected = share * kSeedsOfAKind;
      const double sigma = std::sqrt(kSeedsOfAKind * share * (1.0 - share));
      EXPECT_NEAR(static_cast<double>(count), expected, 4.0 * sigma)
          << building_kinds()[kind] << " " << difficulty_names()[static_cast<std::size_t>(i)];
    }
  }
}

/// Judged by the world alone, not by what the generator says of itself.
bool shows(const World& world, Difficulty difficulty) {
  const auto any_thing = [&](auto is) {
    return std::any_of(world.obstacles.begin(), world.obstacles.end(), is);
  };
  switch (difficulty) {
    case Difficulty::low_thing:
      return any_thing(
          [](const WorldObstacle& o) { return size_of(o).z_m >= 0.08 && size_of(o).z_m <= 0.15; });
    case Difficulty::overhang:
      return any_thing([](const WorldObstacle& o) {
        return o.kind == ObstacleKind::table && size_of(o).z_m >= 0.4 && size_of(o).z_m <= 1.15 &&
               o.name.rfind("table", 0) != 0;
      });
    case Difficulty::pinch:
      return std::any_of(world.widenings.begin(), world.widenings.end(), [&](const Widening& w) {
        return w.width_m == 0.8 || (w.width_m == 1.5 && w.width_m < world.width_m);
      });
    case Difficulty::dark:
      return std::any_of(world.lights.begin(), world.lights.end(), [](const LightRow& row) {
        return row.level >= 0.03 && row.level <= 0.08 && row.to_m - row.from_m >= 8.0;
      });
    case Difficulty::bend:
      return !world.turns.empty();
    case Difficulty::pocket:
      return any_thing([](const WorldObstacle& o) { return o.name == "screen_3"; });
    case Difficulty::crowd:
      return world.walks.size() >= 3 && !world.standers.empty() && !world.steps_in_front.empty();
    case Difficulty::thin_pole:
      return any_thing([](const WorldObstacle& o) {
        return size_of(o).x_m <= 0.08 && size_of(o).y_m <= 0.08 && size_of(o).z_m > 1.0;
      });
    case Difficulty::sunlight:
      return world.sun.has_value() && !world.windows.empty();
    case Difficulty::ring:
      return any_thing([&](const WorldObstacle& o) {
        return o.kind == ObstacleKind::wall && o.at.y_m == 0.0 && size_of(o).x_m >= 2.4;
      });
    case Difficulty::side_branch:
      return std::any_of(world.widenings.begin(), world.widenings.end(), [&](const Widening& w) {
        return w.width_m > world.width_m + 3.99 && w.to_m - w.from_m < 2.21;
      });
    case Difficulty::glass:
      return any_thing([](const WorldObstacle& o) { return o.kind == ObstacleKind::glass; });
    case Difficulty::stairs:
      return any_thing([](const WorldObstacle& o) { return o.kind == ObstacleKind::stairs; });
    case Difficulty::wet_floor:
      return !world.floor_patches.empty();
    case Difficulty::late_thing:
      return any_thing([](const WorldObstacle& o) { return o.appears_after_m > 0.0; });
  }
  return false;
}

TEST(RandomWorlds, ShowInTheWorldWhatTheySayThatTheyHave) {
  each_building([](const RandomWorld& drawn) {
    for (const Difficulty difficulty : drawn.difficulties) {
      EXPECT_TRUE(shows(drawn.world, difficulty))
          << drawn.world.name << " " << difficulty_names()[static_cast<std::size_t>(difficulty)];
    }
  });
}

TEST(RandomWorlds, HaveEachFaultOfTheEyesInAQuarterOfThem) {
  std::map<std::string, int> counts;
  struct Counter {
    std::map<std::string, int>& counts;
    void number(const char* key, double& field, config::Unit /*unit*/, config::Range /*range*/,
                const char* /*help*/) {
      counts[key] += field != 0.0 ? 1 : 0;
    }
  };
  each_building([&](const RandomWorld& drawn) {
    Counter counter{counts};
    EyeFaults eyes = drawn.world.eyes;
    visit(counter, eyes);
  });
  EXPECT_EQ(counts.size(), 11U);
  const double all = static_cast<double>(kSeedsOfAKind * building_kinds().size());
  for (const auto& [fault, count] : counts) {
    EXPECT_NEAR(count, 0.25 * all, 4.0 * std::sqrt(all * 0.25 * 0.75)) << fault;
  }
}

/// The middle one of a figure over all buildings of a kind.
template <class Figure>
double median_of_kind(BuildingKind kind, Figure figure) {
  std::vector<double> values;
  for (const RandomWorld& drawn : drawn_buildings()[static_cast<std::size_t>(kind)]) {
    values.push_back(figure(drawn.world));
  }
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

TEST(RandomWorlds, OfTheKindsDifferAsTheBuildingsDo) {
  const auto width = [](const World& w) { return w.width_m; };
  const auto height = [](const World& w) { return w.height_m; };
  const auto light = [](const World& w) {
    double best = 0.0;
    for (const LightRow& row : w.lights) best = std::max(best, row.level);
    return best;
  };
  using K = BuildingKind;
  EXPECT_LT(median_of_kind(K::old_house, width), median_of_kind(K::office, width));
  EXPECT_LT(median_of_kind(K::office, width), median_of_kind(K::hospital, width));
  EXPECT_LT(median_of_kind(K::hospital, width), median_of_kind(K::school, width));
  EXPECT_LT(median_of_kind(K::basement, height), median_of_kind(K::office, height));
  EXPECT_LT(median_of_kind(K::office, height), median_of_kind(K::school, height));
  EXPECT_LT(median_of_kind(K::basement, light), 0.45);
  EXPECT_GT(median_of_kind(K::hospital, light), 0.7);
  each_building([](const RandomWorld& drawn) {
    if (drawn.kind == BuildingKind::basement) {
      EXPECT_TRUE(drawn.world.windows.empty());
    }
  });
}

TEST(RandomWorlds, OfDifferentSeedsDiffer) {
  std::set<std::string> texts;
  each_building([&](const RandomWorld& drawn) {
    texts.insert(drawn.yaml.substr(drawn.yaml.find("corridor:")));
  });
  EXPECT_EQ(texts.size(), kSeedsOfAKind * building_kinds().size());
}

/// FNV-1a: short to write and the same everywhere.
std::uint64_t hash_of(const std::string& text) {
  std::uint64_t hash = 0xCBF29CE484222325ULL;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3ULL;
  return hash;
}

TEST(RandomWorlds, OfOneSeedAreTheSameBytesOnEveryMachine) {
  std::uint64_t hash = 0;
  each_building([&](const RandomWorld& drawn) { hash = hash * 31 + hash_of(drawn.yaml); });
  // Changes whenever what is drawn changes: then results on drawn worlds cannot be compared with
  // those before, and docs/results.md is to be measured anew.
  EXPECT_EQ(hash, 0x5AC1DCD7626EA9FEULL) << fmt::format("0x{:X}ULL", hash);
  EXPECT_EQ(draw_random_world(BuildingKind::school, 12).yaml,
            draw_random_world(BuildingKind::school, 12).yaml);
}

TEST(WorldWriter, WritesShippedWorldsSoThatTheyAreReadBackTheSame) {
  for (const char* name : {"corridor_a", "corridor_b", "hard_narrow", "bend", "objects_find",
                           "find_and_return", "patrol", "empty"}) {
    const std::string file = std::string(STRIATE_SOURCE_DIR "/config/worlds/") + name + ".yaml";
    const World world = load_world(file);
    const std::string text = world_as_yaml(world);
    config::Diagnostics diagnostics(file);
    const World again = parse_world(text, diagnostics);
    EXPECT_TRUE(diagnostics.text().empty()) << diagnostics.text();
    EXPECT_EQ(world_as_yaml(again), text);
    EXPECT_EQ(again.obstacles.size(), world.obstacles.size());
    EXPECT_EQ(again.walks.size(), world.walks.size());
    EXPECT_NEAR(again.start.heading_rad, world.start.heading_rad, 1e-4);
    EXPECT_NEAR(again.goal_beyond_m, world.goal_beyond_m, 1e-9);
  }
}

}  // namespace
}  // namespace striate::simulator
