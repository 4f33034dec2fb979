#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "memory/long_term/checksum.hpp"
#include "memory/long_term/damage.hpp"
#include "memory/long_term/forgetting.hpp"
#include "memory/long_term/learning.hpp"
#include "memory/long_term/merging.hpp"
#include "memory/long_term/teaching.hpp"
#include "tests/unit/memory/long_term_fixtures.hpp"

namespace striate::memory_tests {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Taught teach_in_session(Opened& memory, const std::string& name,
                        const std::vector<StoredView>& views,
                        const LongTermSettings& settings = {}) {
  const Session session =
      memory.tables.sessions.begin(SessionKind::teach, "striate test", name, 1700000000);
  const Taught taught = teach(memory.tables, session, name, views, settings);
  memory.tables.sessions.end(session.id, 0.0, "kept");
  return taught;
}

TEST(Checksum, IsCrc32cOnEveryProcessor) {
  const std::string text = "123456789";
  const std::vector<std::uint8_t> bytes(text.begin(), text.end());
  EXPECT_EQ(crc32c(bytes), 0xE3069283U);
  EXPECT_EQ(crc32c_by_tables(bytes), 0xE3069283U);
  EXPECT_EQ(crc32c(std::span(bytes).subspan(4), crc32c(std::span(bytes).first(4))), 0xE3069283U);
  std::vector<std::uint8_t> longer(5003);
  for (std::size_t k = 0; k < longer.size(); ++k) longer[k] = static_cast<std::uint8_t>(k * k / 7);
  for (const std::size_t size : {0U, 1U, 7U, 8U, 1003U, 1535U, 1536U, 1544U, 3072U, 5003U}) {
    const auto part = std::span(longer).first(size);
    EXPECT_EQ(crc32c(part, 17), crc32c_by_tables(part, 17)) << size;
  }
}

TEST(Tables, ALandmarkAndItsViewComeBackAsTheyWere) {
  const Folder folder;
  Opened memory(folder / "home.db", Access::session);
  MemoryTables& tables = memory.tables;
  const Session session = tables.sessions.begin(SessionKind::teach, "s", "", 1);
  Landmark landmark;
  landmark.session = session.id;
  landmark.name = "Buch \"grün\" 'x'";
  landmark.position = MapPosition{1.5, -2.0, 0.04, 0.01, 0.09};
  landmark.strength = 0.75;
  landmark.history = {12, 1.0, {50.125, 40.0}};
  StoredView view = scattered_view(3, 20);
  view.landmark = tables.landmarks.add(landmark);
  view.session = session.id;
  view.range_m = 2.5;
  view.picture = {9, 8, 7};
  tables.views.add(view);
  const Landmark found = find_landmark(tables, landmark.name);
  EXPECT_EQ(found.position->cov_xy_m2, 0.01);
  EXPECT_EQ(found.history.uses, 12);
  EXPECT_THAT(found.history.recent_s, ElementsAre(50.125, 40.0));
  EXPECT_EQ(found.views, 1);
  EXPECT_EQ(found.keypoints, 20);
  const StoredView back = tables.views.of(found.id).front();
  EXPECT_EQ(back.descriptors, view.descriptors);
  EXPECT_EQ(back.keypoints, view.keypoints);
  EXPECT_EQ(back.picture, view.picture);
  EXPECT_EQ(back.range_m, 2.5);
  EXPECT_FALSE(back.bearing_rad.has_value());
  EXPECT_FALSE(back.damaged);
}

TEST(Tables, ValuesThatCannotBeAreRefused) {
  const Folder folder;
  Opened memory(folder / "home.db", Access::session);
  add_landmark(memory.tables, "book", 1);
  Landmark landmark = *memory.tables.landmarks.find("book");
  landmark.strength = 1.0;
  EXPECT_THROW(memory.tables.landmarks.update(landmark), SQLite::Exception);
  EXPECT_THROW(memory.file.database().exec("UPDATE landmark SET recent_uses_s = 'often'"),
               SQLite::Exception);
  EXPECT_THROW(memory.file.database().exec("UPDATE landmark_view SET keypoint_count = 3"),
               SQLite::Exception);
  EXPECT_THROW(memory.file.database().exec("UPDATE session SET kind = 'party'"), SQLite::Exception);
}

TEST(Teaching, ANewThingAnOldThingAndAnAlikeView) {
  const Folder folder;
  Opened memory(folder / "home.db", Access::session);
  const StoredView front = scattered_view(1, 80);
  Taught taught = teach_in_session(memory, "book", {front});
  EXPECT_TRUE(taught.is_new);
  EXPECT_EQ(taught.added, 1);
  EXPECT_THAT(taught.remarks, IsEmpty());
  taught = teach_in_session(memory, "book", {seen_again(front, 4.0F, 5), scattered_view(2, 80)});
  EXPECT_FALSE(taught.is_new);
  EXPECT_EQ(taught.added, 1);
  EXPECT_EQ(taught.merged, 1);
  EXPECT_EQ(memory.tables.landmarks.find("book")->history.uses, 2);
}

TEST(Teaching, SaysThatAThingLooksLikeAnOldOne) {
  const Folder folder;
  Opened memory(folder / "home.db", Access::session);
  const StoredView front = scattered_view(1, 80);
  (void)teach_in_session(memory, "book", {front});
  EXPECT_THAT(teach_in_session(memory, "cup", {scattered_view(2, 80)}).remarks, IsEmpty());
  EXPECT_THAT(teach_in_session(memory, "cover", {seen_again(front, 4.0F, 10)}).remarks,
              ElementsAre(AllOf(HasSubstr("looks like 'book': 70 keypoints agree"))));
}

TEST(Teaching, TooLittleStructureIsRefusedAndLittleIsSaid) {
  const Folder folder;
  Opened memory(folder / "home.db", Access::session);
  EXPECT_THAT(sentence_of([&] { (void)teach_in_session(memory, "wall", {scattered_view(1, 5)}); }),
              AllOf(HasSubstr("view 1 has too little structure: 5 keypoints"),
                    HasSubstr("nothing was kept")));
  EXPECT_FALSE(memory.tables.landmarks.find("wall").has_value());
  EXPECT_THAT(teach_in_session(memory, "door", {scattered_view(1, 20)}).remarks,
              ElementsAre(HasSubstr("has little structure: 20 keypoints")));
}

TEST(Teaching, NamesAreForPeople) {
  EXPECT_EQ(sentence_of([] { check_landmark_name("the grün book no. 5"); }), "");
  for (const std::string& bad : {std::string(), std::string(" x"), std::string("x\n"),
                                 std::string(65, 'x'), std::string("a\0b", 3)}) {
    EXPECT_THAT(sentence_of([&] { check_landmark_name(bad); }), HasSubstr("is no name"));
  }
}

TEST(Teaching, CanBeUndone) {
  const Folder folder;
  Opened memory(folder / "home.db", Access::session);
  (void)teach_in_session(memory, "book", {scattered_view(1, 80)});
  (void)teach_in_session(memory, "book", {scattered_view(2, 80)});
  EXPECT_THAT(undo_teaching(memory.tables), HasSubstr("1 view taken back"));
  EXPECT_EQ(memory.tables.landmarks.find("book")->views, 1);
  (void)undo_teaching(memory.tables);
  EXPECT_FALSE(memory.tables.landmarks.find("book").has_value());
  EXPECT_THAT(sentence_of([&] { (void)undo_teaching(memory.tables); }), HasSubstr("no teaching"));
}

TEST(Teaching, UndoingOneThatAddedNothingLeavesTheOneBeforeAlone) {
  const Folder folder;
  Opened memory(folder / "home.db", Access::session);
  const StoredView front = scattered_view(1, 80);
  (void)teach_in_session(memory, "book", {front});
  (void)teach_in_session(memory, "book", {seen_again(front, 4.0F, 5)});
  EXPECT_THAT(undo_teaching(memory.tables), HasSubstr("nothing of it was there to take back"));
  EXPECT_EQ(memory.tables.landmarks.find("book")->views, 1);
  EXPECT_THAT(undo_teaching(memory.tables), HasSubstr("1 view taken back"));
}

TEST(Teaching, UndoDoesNotReachWhatAnotherRobotWasTaught) {
  const Folder folder;
  Opened ours(folder / "a.db", Access::session);
  Opened theirs(folder / "b.db", Access::session);
  (void)teach_in_session(ours, "lamp", {scattered_view(9, 80)});
  (void)teach_in_session(theirs, "cup", {scattered_view(4, 80)});
  (void)merge(ours.tables, theirs.tables, {});
  (void)undo_teaching(ours.tables);
  EXPECT_FALSE(ours.tables.landmarks.find("lamp").has_value());
  EXPECT_THAT(sentence_of([&] { (void)undo_teaching(ours.tables); }), HasSubstr("no teaching"));
  EXPECT_EQ(ours.tables.landmarks.find("cup")->views, 1);
}

TEST(Tables, ADamagedPictureIsLeftOutSoThatMergingDoesNotMakeItGood) {
  const Folder folder;
  Opened theirs(folder / "b.db", Access::session);
  StoredView view = scattered_view(1, 80);
  view.picture = {1, 2, 3};
  (void)teach_in_session(theirs, "book", {view});
  const std::int64_t book = theirs.tables.landmarks.find("book")->id;
  EXPECT_EQ(theirs.tables.views.of(book).front().picture, view.picture);
  theirs.file.database().exec("UPDATE landmark_view SET picture = x'010204'");
  EXPECT_THAT(theirs.tables.views.of(book).front().picture, IsEmpty());
  EXPECT_FALSE(theirs.tables.views.of(book).front().damaged);
}

TEST(Teaching, ViewsAreCapped) {
  const Folder folder;
  Opened memory(folder / "home.db", Access::session);
  LongTermSettings settings;
  settings.most_views = 3;
  for (unsigned k = 0; k < 6; ++k) {
    (void)teach_in_session(memory, "book", {scattered_view(k, 60)}, settings);
  }
  EXPECT_EQ(memory.tables.landmarks.find("book")->views, 3);
}

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

TEST(Merging, TheSameObjectTaughtTwiceIsOneLandmarkWithBothViews) {
  const Folder folder;
  Opened ours(folder / "a.db", Access::session);
  Opened theirs(folder / "b.db", Access::session);
  const StoredView front = scattered_view(1, 80);
  (void)teach_in_session(ours, "book", {front});
  (void)teach_in_session(ours, "lamp", {scattered_view(9, 80)});
  (void)teach_in_session(theirs, "book", {scattered_view(2, 80)});
  (void)teach_in_session(theirs, "cover", {seen_again(front, 3.0F, 8), scattered_view(3, 80)});
  (void)teach_in_session(theirs, "cup", {scattered_view(4, 80)});
  const std::int64_t book = theirs.tables.landmarks.find("book")->id;
  const std::int64_t cup = theirs.tables.landmarks.find("cup")->id;
  theirs.tables.places.put(Route{book, cup, 3.0, 0.5, 0.1, 0.1, 2, 1});
  const Merged merged = merge(ours.tables, theirs.tables, {});
  EXPECT_EQ(merged.added, 1);
  EXPECT_EQ(merged.joined, 2);
  EXPECT_EQ(merged.views, 3);
  EXPECT_THAT(merged.remarks, ElementsAre(HasSubstr("'cover' is what is known here as 'book'")));
  EXPECT_EQ(ours.tables.landmarks.find("book")->views, 3);
  EXPECT_EQ(ours.tables.landmarks.find("cup")->views, 1);
  ASSERT_EQ(ours.tables.places.routes().size(), 1U);
  EXPECT_EQ(ours.tables.places.routes()[0].to, ours.tables.landmarks.find("cup")->id);
  EXPECT_THAT(find_damage(ours.file.database()), IsEmpty());
}

TEST(Merging, APositionComesAlongWhereThereIsNoMapAndBringsAForgottenOneBack) {
  const Folder folder;
  Opened ours(folder / "a.db", Access::session);
  Opened theirs(folder / "b.db", Access::session);
  add_landmark(ours.tables, "book", 1);
  forget(ours.tables, "book", "asked for");
  add_landmark(theirs.tables, "book", 2);
  Landmark book = *theirs.tables.landmarks.find("book");
  EXPECT_THAT(merge(ours.tables, theirs.tables, {}).remarks, IsEmpty());
  EXPECT_EQ(ours.tables.landmarks.find("book")->retired_why, "");
  book.position = MapPosition{1.5, -2.0, 0.04, 0.01, 0.09};
  theirs.tables.landmarks.update(book);
  EXPECT_THAT(merge(ours.tables, theirs.tables, {}).remarks, IsEmpty());
  EXPECT_EQ(ours.tables.landmarks.find("book")->position->x_m, 1.5);
  EXPECT_THAT(merge(ours.tables, theirs.tables, {}).remarks, IsEmpty());
}

/// All rows of all tables, as text.
std::string all_rows(Opened& memory) {
  std::string rows;
  for (const char* table :
       {"session", "landmark", "landmark_view", "route", "obstacle_cell", "episode"}) {
    SQLite::Statement query(memory.file.database(), std::string("SELECT * FROM ") + table);
    while (query.executeStep()) {
      for (int k = 0; k < query.getColumnCount(); ++k) rows += query.getColumn(k).getString() + "|";
      rows += "\n";
    }
  }
  return rows;
}

TEST(Merging, TheSameMemoryTwiceAddsNothing) {
  const Folder folder;
  Opened ours(folder / "a.db", Access::session);
  Opened theirs(folder / "b.db", Access::session);
  (void)teach_in_session(ours, "lamp", {scattered_view(9, 80)});
  for (unsigned k = 0; const char* name : {"book", "cup"}) add_landmark(theirs.tables, name, ++k);
  Session mission = theirs.tables.sessions.begin(SessionKind::mission, "striate", "corridor", 7);
  Landmark book = *theirs.tables.landmarks.find("book");
  book.position = MapPosition{1.5, -2.0, 0.04, 0.01, 0.09};
  book.history = {3, 0.0, {40.0, 20.0, 0.0}};
  theirs.tables.landmarks.update(book);
  theirs.tables.places.put(
      Route{book.id, theirs.tables.landmarks.find("cup")->id, 3.0, 0.5, 0.1, 0.1, 2, 1});
  theirs.tables.places.put(ObstacleCell{3, 4, 2.0, 30.0});
  Episode episode;
  episode.session = mission.id;
  episode.time_s = 30.0;
  episode.kind = "collision";
  theirs.tables.sessions.add(episode);
  theirs.tables.sessions.end(mission.id, 60.0, "success");
  EXPECT_FALSE(merge(ours.tables, theirs.tables, {}).nothing_new());
  const std::string once = all_rows(ours);
  EXPECT_TRUE(merge(ours.tables, theirs.tables, {}).nothing_new());
  EXPECT_EQ(all_rows(ours), once);
  // What the other has learned since comes in, and only that.
  mission = theirs.tables.sessions.begin(SessionKind::mission, "striate", "corridor", 900);
  book.history = {4, 0.0, {70.0, 40.0, 20.0, 0.0}};
  theirs.tables.landmarks.update(book);
  theirs.tables.sessions.end(mission.id, 60.0, "success");
  const Merged grown = merge(ours.tables, theirs.tables, {});
  EXPECT_EQ(grown.sessions, 1);
  EXPECT_EQ(grown.views, 0);
  EXPECT_EQ(ours.tables.landmarks.find("book")->history.uses, 4);
  EXPECT_EQ(ours.tables.sessions.episodes(-1).size(),
            2U);  // the lamp was taught, and a collision came in
  EXPECT_EQ(ours.tables.sessions.operating_now_s(), 120.0);
  EXPECT_TRUE(merge(theirs.tables, theirs.tables, {}).nothing_new());
}

void put_at(MemoryTables& tables, const std::string& name, Point2 at) {
  tables.landmarks.set_position(tables.landmarks.find(name)->id, {at.x_m, at.y_m, 0.01, 0.0, 0.01});
}

TEST(Merging, TwoLandmarksOnBothMapsPutTheOtherMapOnOurs) {
  const Folder folder;
  Opened ours(folder / "a.db", Access::session);
  Opened theirs(folder / "b.db", Access::session);
  const Pose2 origin{4.0, -3.0, 1.0};  // of theirs, on ours
  const std::vector<std::pair<const char*, Point2>> places = {
      {"book", {1.0, 1.0}}, {"cup", {5.0, -1.0}}, {"lamp", {9.0, 2.0}}, {"moved", {3.0, 3.0}}};
  for (unsigned k = 0; const auto& [name, at] : places) {
    add_landmark(theirs.tables, name, ++k);
    put_at(theirs.tables, name, at);
    if (std::string(name) == "lamp") continue;
    add_landmark(ours.tables, name, 100 + k);
    put_at(ours.tables, name, std::string(name) == "moved" ? Point2{50, 50} : to_outer(origin, at));
  }
  theirs.tables.places.put(ObstacleCell{20, 10, 2.0, 0.0});
  EXPECT_THAT(merge(ours.tables, theirs.tables, {}).remarks, IsEmpty());
  const MapPosition lamp = ours.tables.landmarks.find("lamp")->position.value();
  EXPECT_NEAR(lamp.x_m, to_outer(origin, Point2{9.0, 2.0}).x_m, 1e-6);
  EXPECT_NEAR(lamp.y_m, to_outer(origin, Point2{9.0, 2.0}).y_m, 1e-6);
  EXPECT_NEAR(ours.tables.landmarks.find("moved")->position->x_m, 50.0, 1e-9);
  const Point2 cell = to_outer(origin, Point2{2.05, 1.05});
  ASSERT_EQ(ours.tables.places.cells().size(), 1U);
  EXPECT_NEAR(ours.tables.places.cells()[0].column * kObstacleCell_m, cell.x_m, 0.11);
  EXPECT_NEAR(ours.tables.places.cells()[0].row * kObstacleCell_m, cell.y_m, 0.11);
}

TEST(Merging, AMapThatCannotBePutOnOursIsLeftOutAndSaidSo) {
  const Folder folder;
  Opened ours(folder / "a.db", Access::session);
  Opened theirs(folder / "b.db", Access::session);
  for (unsigned k = 0; const char* name : {"book", "cup"}) {
    add_landmark(theirs.tables, name, ++k);
    put_at(theirs.tables, name, {static_cast<double>(k), 0.0});
  }
  add_landmark(ours.tables, "book", 7);
  put_at(ours.tables, "book", {20.0, 0.0});
  EXPECT_THAT(merge(ours.tables, theirs.tables, {}).remarks,
              ElementsAre(HasSubstr("1 positions and 0 obstacle cells")));
  EXPECT_FALSE(ours.tables.landmarks.find("cup")->position.has_value());
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
}  // namespace striate::memory_tests
