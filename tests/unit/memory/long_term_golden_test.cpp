#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "striate/memory/long_term/damage.hpp"
#include "tests/unit/memory/long_term_fixtures.hpp"

namespace striate::memory::memory_tests {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string golden_as_database(const Folder& folder, const std::string& name) {
  std::ifstream stream(std::string(STRIATE_SOURCE_DIR "/tests/golden/") + name + ".sql");
  std::stringstream sql;
  sql << stream.rdbuf();
  const std::string file = folder / (name + ".db");
  SQLite::Database(file, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec(sql.str());
  return file;
}

TEST(GoldenMemory, Version1OpensAndMatches) {
  const Folder folder;
  const std::string file = golden_as_database(folder, "memory_v1");
  Opened memory(file, Access::session);
  EXPECT_THAT(memory.file.notices(), IsEmpty());
  EXPECT_THAT(find_damage(memory.file.database()), IsEmpty());
  const Landmark book = memory.tables.landmarks.find("book").value();
  EXPECT_EQ(book.position->x_m, 12.5);
  EXPECT_EQ(book.position->var_y_m2, 0.09);
  EXPECT_EQ(book.strength, 0.8125);
  EXPECT_EQ(book.history.uses, 12);
  EXPECT_THAT(book.history.recent_s, ElementsAre(900.5, 60.0));
  const StoredView view = memory.tables.views.of(book.id).at(0);
  const StoredView expected = scattered_view(1, 12);
  EXPECT_FALSE(view.damaged);
  EXPECT_EQ(view.descriptors, expected.descriptors);
  EXPECT_EQ(view.keypoints, expected.keypoints);
  EXPECT_THAT(view.image, ElementsAre(1, 2, 3));
  const Landmark cup = memory.tables.landmarks.find("old cup").value();
  EXPECT_EQ(cup.retired_s, 1000.0);
  EXPECT_EQ(cup.retired_why, "asked for");
  const Route route = memory.tables.places.routes().at(0);
  EXPECT_EQ(route.to, cup.id);
  EXPECT_EQ(route.successes, 4);
  const ObstacleCell cell = memory.tables.places.cells().at(0);
  EXPECT_EQ(cell.column, -3);
  EXPECT_EQ(cell.row, 17);
  const std::vector<Episode> episodes = memory.tables.sessions.episodes(-1);
  ASSERT_EQ(episodes.size(), 2U);
  EXPECT_EQ(episodes[1].kind, "emergency stop");
  EXPECT_EQ(episodes[1].heading_rad, 0.5);
  EXPECT_EQ(memory.tables.sessions.operating_now_s(), 1000.0);
}

/// A new version of the tables must not be shipped without a way to it from every older one, and
/// without a golden memory of its own.
TEST(GoldenMemory, EveryVersionHasOneAndAStepLeadsToIt) {
  EXPECT_EQ(schema::steps().size(), static_cast<std::size_t>(schema::kVersion - 1));
  for (int version = 1; version <= schema::kVersion; ++version) {
    const Folder folder;
    const std::string file = golden_as_database(folder, "memory_v" + std::to_string(version));
    Opened memory(file, Access::session);
    EXPECT_THAT(find_damage(memory.file.database()), IsEmpty());
  }
}

}  // namespace
}  // namespace striate::memory::memory_tests
