#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "striate/memory/long_term/forgetting.hpp"
#include "striate/memory/long_term/merging.hpp"
#include "tests/unit/memory/long_term_fixtures.hpp"

namespace striate::memory::memory_tests {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

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
  view.image = {9, 8, 7};
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
  EXPECT_EQ(back.image, view.image);
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

TEST(Tables, ADamagedImageIsLeftOutSoThatMergingDoesNotMakeItGood) {
  const Folder folder;
  Opened theirs(folder / "b.db", Access::session);
  StoredView view = scattered_view(1, 80);
  view.image = {1, 2, 3};
  (void)teach_in_session(theirs, "book", {view});
  const std::int64_t book = theirs.tables.landmarks.find("book")->id;
  EXPECT_EQ(theirs.tables.views.of(book).front().image, view.image);
  theirs.file.database().exec("UPDATE landmark_view SET picture = x'010204'");
  EXPECT_THAT(theirs.tables.views.of(book).front().image, IsEmpty());
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

}  // namespace
}  // namespace striate::memory::memory_tests
