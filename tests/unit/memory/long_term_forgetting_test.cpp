#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "striate/memory/long_term/forgetting.hpp"
#include "striate/memory/long_term/learning.hpp"
#include "striate/memory/long_term/memory_writer.hpp"
#include "tests/unit/memory/long_term_fixtures.hpp"

namespace striate::memory::memory_tests {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

TEST(Forgetting, OnlyWhatIsWeakInactiveNotTaughtAndNotPinned) {
  Landmark landmark;
  landmark.kind = LandmarkKind::candidate;
  landmark.strength = 0.1;
  landmark.history = {1, 0.0, {0.0}};
  const LongTermSettings settings;
  const double late_s = 100000.0;  // ln(late^-0.5) = -5.76
  EXPECT_THAT(why_forgettable(landmark, late_s, settings),
              HasSubstr("weak (strength 0.10) and inactive (activation -5.8)"));
  EXPECT_EQ(why_forgettable(landmark, 1000.0, settings), "");
  Landmark other = landmark;
  other.strength = 0.3;
  EXPECT_EQ(why_forgettable(other, late_s, settings), "");
  other = landmark;
  other.pinned = true;
  EXPECT_EQ(why_forgettable(other, late_s, settings), "");
  other = landmark;
  other.kind = LandmarkKind::taught;
  EXPECT_EQ(why_forgettable(other, late_s, settings), "");
}

TEST(Forgetting, IsReversible) {
  const Folder folder;
  Opened memory(folder / "home.db", Access::session);
  add_landmark(memory.tables, "book", 1);
  forget(memory.tables, "book", "asked for");
  EXPECT_THAT(memory.tables.landmarks.all(false), IsEmpty());
  EXPECT_EQ(memory.tables.landmarks.all(true).size(), 1U);
  EXPECT_THAT(sentence_of([&] { forget(memory.tables, "book", ""); }), HasSubstr("already"));
  restore(memory.tables, "book");
  EXPECT_EQ(memory.tables.landmarks.all(false).size(), 1U);
  EXPECT_THAT(sentence_of([&] { restore(memory.tables, "book"); }), HasSubstr("not forgotten"));
  EXPECT_THAT(sentence_of([&] { restore(memory.tables, "bok"); }),
              HasSubstr("there is no landmark 'bok'; did you mean 'book'?"));
}

TEST(Forgetting, PruneRetiresTheWeakAndRemovesTheLongRetired) {
  const Folder folder;
  Opened memory(folder / "home.db", Access::session);
  MemoryTables& tables = memory.tables;
  for (unsigned k = 0; const char* name : {"weak", "gone", "taught"}) {
    add_landmark(tables, name, ++k);
  }
  Landmark weak = *tables.landmarks.find("weak");
  weak.strength = 0.05;
  tables.landmarks.update(weak);
  tables.landmarks.rename(weak.id, "weak", LandmarkKind::candidate);
  forget(tables, "gone", "asked for");
  const Session session = tables.sessions.begin(SessionKind::mission, "s", "", 1);
  tables.sessions.end(session.id, 200000.0, "success");
  const PrunePlan plan = plan_prune(tables, {});
  ASSERT_EQ(plan.retire.size(), 1U);
  ASSERT_EQ(plan.remove.size(), 1U);
  EXPECT_EQ(plan.retire[0].name, "weak");
  EXPECT_EQ(plan.remove[0].name, "gone");
  prune(tables, plan, {});
  EXPECT_TRUE(tables.landmarks.find("weak")->retired_s.has_value());
  EXPECT_FALSE(tables.landmarks.find("gone").has_value());
  EXPECT_TRUE(plan_prune(tables, {}).empty());
}

TEST(Growth, ARobotThatStandsStillForAnHourAddsLessThan100Kilobytes) {
  const Folder folder;
  const std::string file = folder / "home.db";
  std::int64_t landmark = 0;
  std::int64_t session = 0;
  {
    Opened memory(file, Access::session);
    add_landmark(memory.tables, "book", 1);
    landmark = memory.tables.landmarks.find("book")->id;
  }
  const auto before = std::filesystem::file_size(file);
  {
    MemoryWriter writer(file, options(Access::session));
    writer.commit([&](MemoryTables& tables) {
      session = tables.sessions.begin(SessionKind::mission, "s", "", 1).id;
    });
    Learning learning({});
    for (int cycle = 0; cycle < 36000; ++cycle) {
      const double now_s = 0.1 * cycle;
      if (learning.seen(landmark, {0.01 * (cycle % 3), 0.0})) {
        writer.post([now_s](MemoryTables& tables) { keep_sighting(tables, "book", now_s, {}); });
      }
      if (cycle % 600 == 0) {
        writer.post([=](MemoryTables& tables) { tables.sessions.note_time(session, now_s); });
      }
    }
    writer.commit([&](MemoryTables& tables) { tables.sessions.end(session, 3600.0, "stood"); });
  }
  EXPECT_LT(std::filesystem::file_size(file) - before, 100000U);
  Opened memory(file, Access::read);
  EXPECT_EQ(memory.tables.landmarks.find("book")->history.uses, 2);
  EXPECT_DOUBLE_EQ(memory.tables.sessions.operating_now_s(), 3600.0);
}

}  // namespace
}  // namespace striate::memory::memory_tests
