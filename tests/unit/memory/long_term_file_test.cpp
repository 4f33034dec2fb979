#include <SQLiteCpp/Transaction.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "striate/memory/long_term/damage.hpp"
#include "striate/memory/long_term/memory_errors.hpp"
#include "tests/unit/memory/long_term_fixtures.hpp"

namespace striate::memory::memory_tests {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

void execute(const std::string& path, const std::string& sql) {
  SQLite::Database database(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  database.exec(sql);
}

TEST(MemoryFile, AFreshMemoryTellsWhatItIs) {
  const Folder folder;
  Opened memory(folder / "home.db", Access::session);
  SQLite::Database& database = memory.file.database();
  EXPECT_EQ(database.execAndGet("PRAGMA application_id").getInt64(), schema::kApplicationId);
  EXPECT_EQ(database.execAndGet("PRAGMA user_version").getInt(), 1);
  EXPECT_EQ(database.execAndGet("PRAGMA page_size").getInt(), 32768);
  EXPECT_EQ(database.execAndGet("PRAGMA journal_mode").getString(), "wal");
  EXPECT_EQ(database
                .execAndGet("SELECT count(*) FROM sqlite_master WHERE type = 'table' AND sql "
                            "LIKE '%STRICT%'")
                .getInt(),
            7);
  EXPECT_THAT(find_damage(database), IsEmpty());
}

TEST(MemoryFile, WhatIsNotThereIsSaidWithTheWayToMakeIt) {
  const Folder folder;
  const std::string file = folder / "none.db";
  EXPECT_THAT(sentence_of([&] { Opened(file, Access::read); }),
              AllOf(HasSubstr("none.db: there is no such memory"), HasSubstr("striate teach")));
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_THAT(sentence_of([&] { Opened(folder.path(), Access::session); }),
              HasSubstr("a folder, not a memory"));
  EXPECT_THAT(sentence_of([&] { Opened(folder / "no/such/home.db", Access::session); }),
              HasSubstr("it cannot be written"));
}

TEST(MemoryFile, AForeignDatabaseIsRefusedAndNotTouched) {
  const Folder folder;
  const std::string file = folder / "other.db";
  execute(file, "CREATE TABLE people (name TEXT)");
  const auto before = std::filesystem::last_write_time(file);
  for (const Access access : {Access::read, Access::edit, Access::session}) {
    EXPECT_THAT(sentence_of([&] { Opened(file, access); }),
                AllOf(HasSubstr("other.db: an SQLite file, but not a memory"),
                      HasSubstr("name another file")));
  }
  EXPECT_EQ(std::filesystem::last_write_time(file), before);
}

TEST(MemoryFile, ATextFileIsNoMemory) {
  const Folder folder;
  std::ofstream(folder / "notes.txt") << std::string(5000, 'x');
  EXPECT_THAT(sentence_of([&] { Opened(folder / "notes.txt", Access::session); }),
              HasSubstr("this is no SQLite file"));
}

TEST(MemoryFile, ATruncatedFileIsSaidToBeDamaged) {
  const Folder folder;
  const std::string file = folder / "home.db";
  {
    Opened memory(file, Access::session);
    for (unsigned k = 0; k < 20; ++k) add_landmark(memory.tables, std::to_string(k), k, 200);
  }
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  for (const Access access : {Access::read, Access::session}) {
    EXPECT_THAT(sentence_of([&] {
                  Opened memory(file, access);
                  const auto damage = find_damage(memory.file.database());
                  if (!damage.empty()) throw UserError("the file is damaged: " + damage.front());
                }),
                AllOf(HasSubstr("the file is damaged")));
  }
}

TEST(MemoryFile, AFlippedByteInADescriptorIsFoundAndNamed) {
  const Folder folder;
  const std::string file = folder / "home.db";
  StoredView view;
  {
    Opened memory(file, Access::session);
    add_landmark(memory.tables, "book", 1);
    add_landmark(memory.tables, "cup", 2);
    view = memory.tables.views.of(memory.tables.landmarks.find("book")->id).front();
  }
  std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
  std::string content((std::istreambuf_iterator<char>(bytes)), std::istreambuf_iterator<char>());
  const std::string needle(reinterpret_cast<const char*>(view.descriptors[7].data()), 32);
  const std::size_t at = content.find(needle);
  ASSERT_NE(at, std::string::npos);
  bytes.seekp(static_cast<std::streamoff>(at));
  bytes.put(static_cast<char>(needle[0] ^ 0x04));
  bytes.close();

  Opened memory(file, Access::read);
  EXPECT_THAT(find_damage(memory.file.database()),
              ElementsAre(AllOf(HasSubstr("landmark 'book', view 1"), HasSubstr("checksum"),
                                HasSubstr("striate teach book"))));
  int damaged = 0;
  memory.tables.views.for_each([&](const StoredView& one) { damaged += one.damaged ? 1 : 0; });
  EXPECT_EQ(damaged, 1);
}

TEST(MemoryFile, TheSecondWriterIsToldWhoTheFirstIs) {
  const Folder folder;
  const std::string file = folder / "home.db";
  const MemoryWriter first(file, options(Access::session));
  EXPECT_THAT(sentence_of([&] { MemoryWriter(file, options(Access::session)); }),
              AllOf(HasSubstr("unit_memory (process "), HasSubstr("is writing into this memory"),
                    HasSubstr("wait until it has ended")));
}

TEST(MemoryFile, TheSecondWriterIsMetByWhateverNameItComes) {
  const Folder folder;
  const std::string file = folder / "home.db";
  const MemoryWriter first(file, options(Access::session));
  std::filesystem::create_symlink(file, folder / "link.db");
  std::filesystem::create_hard_link(file, folder / "hard.db");
  std::filesystem::create_directory(folder / "sub");
  for (const std::string& name : {std::string("link.db"), std::string("hard.db"),
                                  std::string("sub/../home.db"), std::string("./home.db")}) {
    EXPECT_THAT(sentence_of([&] { MemoryWriter(folder / name, options(Access::session)); }),
                HasSubstr("is writing into this memory"))
        << name;
  }
}

TEST(MemoryFile, AReaderAndAnEditGoOnWhileASessionWrites) {
  const Folder folder;
  const std::string file = folder / "home.db";
  MemoryWriter writer(file, options(Access::session));
  writer.commit([](MemoryTables& tables) { add_landmark(tables, "first", 0); });
  std::atomic<bool> stop = false;
  std::thread load([&] {
    for (unsigned k = 1; !stop && k < 400; ++k) {
      writer.commit(
          [k](MemoryTables& tables) { add_landmark(tables, "load " + std::to_string(k), k, 150); });
    }
  });
  int before = 0;
  for (int k = 0; k < 20; ++k) {
    Opened reader(file, Access::read);
    int views = 0;
    int damaged = 0;
    reader.tables.views.for_each([&](const StoredView& view) {
      ++views;
      damaged += view.damaged ? 1 : 0;
    });
    EXPECT_EQ(damaged, 0);
    EXPECT_GE(views, before);
    before = views;
    Opened edit(file, Access::edit);
    Landmark landmark = *edit.tables.landmarks.find("first");
    landmark.pinned = k % 2 == 0;
    edit.tables.landmarks.update(landmark);
  }
  stop = true;
  load.join();
}

TEST(MemoryFile, IsCopiedWholeAlsoWhereItIsOpenedToRead) {
  const Folder folder;
  const std::string file = folder / "home.db";
  {
    Opened memory(file, Access::session);
    add_landmark(memory.tables, "book", 1);
  }
  for (const Access access : {Access::read, Access::edit}) {
    const std::string copy = folder / (access == Access::read ? "read.db" : "edited.db");
    Opened(file, access).file.copy_to(copy);
    EXPECT_TRUE(Opened(copy, Access::read).tables.landmarks.find("book").has_value());
  }
  Opened reader(file, Access::read);
  reader.file.copy_to(folder / "third.db");
  EXPECT_THROW(reader.file.database().exec("DELETE FROM landmark"), SQLite::Exception);
}

TEST(MemoryFile, ASessionThatDidNotEndIsMarkedAndTheFileChecked) {
  const Folder folder;
  const std::string file = folder / "home.db";
  {
    Opened memory(file, Access::session);
    (void)memory.tables.sessions.begin(SessionKind::mission, "striate test", "", 1700000000);
  }
  Opened memory(file, Access::session);
  EXPECT_THAT(memory.file.notices(),
              ElementsAre(AllOf(HasSubstr("session 1 (mission) ended without closing"),
                                HasSubstr("found no damage"))));
  EXPECT_EQ(memory.tables.sessions.all().front().state, SessionState::crashed);
}

TEST(MemoryFile, LeavesNothingBesideIt) {
  const Folder folder;
  const std::string file = folder / "home.db";
  { Opened memory(file, Access::session); }
  { Opened memory(file, Access::read); }
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    names.push_back(entry.path().filename());
  }
  EXPECT_THAT(names, testing::UnorderedElementsAre("home.db"));
}

}  // namespace
}  // namespace striate::memory::memory_tests
