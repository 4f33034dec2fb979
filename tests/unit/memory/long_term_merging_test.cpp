#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "striate/memory/long_term/damage.hpp"
#include "striate/memory/long_term/forgetting.hpp"
#include "striate/memory/long_term/merging.hpp"
#include "tests/unit/memory/long_term_fixtures.hpp"

namespace striate::memory::memory_tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

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
  EXPECT_THAT(merged.remarks,
              ElementsAre(HasSubstr("'book': no view of the one looks like any view of the other"),
                          HasSubstr("'cover' is what is known here as 'book'")));
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
  EXPECT_THAT(merge(ours.tables, theirs.tables, {}).remarks,
              ElementsAre(HasSubstr("no view of the one looks like")));
  EXPECT_EQ(ours.tables.landmarks.find("book")->retired_why, "");
  book.position = MapPosition{1.5, -2.0, 0.04, 0.01, 0.09};
  theirs.tables.landmarks.update(book);
  EXPECT_THAT(merge(ours.tables, theirs.tables, {}).remarks, IsEmpty());
  EXPECT_EQ(ours.tables.landmarks.find("book")->position->x_m, 1.5);
  EXPECT_THAT(merge(ours.tables, theirs.tables, {}).remarks, IsEmpty());
}

TEST(Merging, AViewThatIsHereAlreadyNeverComesInAgain) {
  const Folder folder;
  Opened ours(folder / "a.db", Access::session);
  Opened theirs(folder / "b.db", Access::session);
  // Too little in common for the rule of recognition: equal all the same.
  const StoredView poor = scattered_view(4, 10);
  LongTermSettings settings;
  settings.least_keypoints = 5;
  const std::vector<StoredView> all = {scattered_view(1, 80), scattered_view(2, 80),
                                       scattered_view(3, 80), poor};
  for (Opened* memory : {&ours, &theirs}) {
    const Session session =
        memory->tables.sessions.begin(SessionKind::teach, "striate", "", memory == &ours ? 5 : 6);
    (void)teach(memory->tables, session, "book", memory == &ours ? all : std::vector{poor},
                settings);
    memory->tables.sessions.end(session.id, 0.0, "kept");
  }
  for (int k = 0; k < 6; ++k) {
    EXPECT_EQ(merge(ours.tables, theirs.tables, settings).views, 0) << k;
    EXPECT_EQ(ours.tables.landmarks.find("book")->views, 4) << k;
  }
}

TEST(Merging, WhatHadNoRoomPushesNothingOutTheNextTime) {
  const Folder folder;
  Opened ours(folder / "a.db", Access::session);
  Opened theirs(folder / "b.db", Access::session);
  LongTermSettings settings;
  settings.most_views = 3;
  for (Opened* memory : {&ours, &theirs}) {
    const unsigned from = memory == &ours ? 1 : 11;
    const Session session =
        memory->tables.sessions.begin(SessionKind::teach, "striate", "", 5 + from);
    (void)teach(
        memory->tables, session, "book",
        {scattered_view(from, 80), scattered_view(from + 1, 60), scattered_view(from + 2, 70)},
        settings);
    memory->tables.sessions.end(session.id, 0.0, "kept");
  }
  (void)merge(ours.tables, theirs.tables, settings);
  const auto views = [&] {
    std::vector<std::int64_t> ids;
    for (const StoredView& view : ours.tables.views.of(ours.tables.landmarks.find("book")->id)) {
      ids.push_back(view.id);
    }
    return ids;
  };
  const std::vector<std::int64_t> once = views();
  for (int k = 0; k < 3; ++k) {
    EXPECT_TRUE(merge(ours.tables, theirs.tables, settings).nothing_new());
    EXPECT_EQ(views(), once);
  }
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
    add_landmark(ours.tables, name, k);
    put_at(ours.tables, name,
           std::string(name) == "moved" ? Point2{50, 50} : transform(origin, at));
  }
  theirs.tables.places.put(ObstacleCell{20, 10, 2.0, 0.0});
  EXPECT_THAT(merge(ours.tables, theirs.tables, {}).remarks, IsEmpty());
  const MapPosition lamp = ours.tables.landmarks.find("lamp")->position.value();
  EXPECT_NEAR(lamp.x_m, transform(origin, Point2{9.0, 2.0}).x_m, 1e-6);
  EXPECT_NEAR(lamp.y_m, transform(origin, Point2{9.0, 2.0}).y_m, 1e-6);
  EXPECT_NEAR(ours.tables.landmarks.find("moved")->position->x_m, 50.0, 1e-9);
  const Point2 cell = transform(origin, Point2{2.05, 1.05});
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
  add_landmark(ours.tables, "book", 1);
  put_at(ours.tables, "book", {20.0, 0.0});
  EXPECT_THAT(merge(ours.tables, theirs.tables, {}).remarks,
              ElementsAre(HasSubstr("1 positions and 0 obstacle cells")));
  EXPECT_FALSE(ours.tables.landmarks.find("cup")->position.has_value());
}

}  // namespace
}  // namespace striate::memory::memory_tests
