#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/memory/long_term_fixtures.hpp"

namespace striate::memory::memory_tests {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

const schema::Step kNextStep = {schema::kVersion + 1,
                                "ALTER TABLE landmark ADD COLUMN colour TEXT NOT NULL DEFAULT ''"};

MemoryOptions with_next_version(Access access) {
  MemoryOptions given = options(access);
  given.version = schema::kVersion + 1;
  given.steps = {&kNextStep, 1};
  return given;
}

TEST(MemoryFile, ANewerVersionIsOfferedReadOnly) {
  const Folder folder;
  const std::string file = folder / "home.db";
  {
    Opened memory(file, with_next_version(Access::session));
    add_landmark(memory.tables, "book", 1);
  }
  EXPECT_THAT(sentence_of([&] { Opened(file, Access::session); }),
              AllOf(HasSubstr("version 2, newer than this program's 1"), HasSubstr("can be read")));
  EXPECT_THAT(sentence_of([&] { Opened(file, Access::edit); }), HasSubstr("newer"));
  Opened memory(file, Access::read);
  EXPECT_THAT(memory.file.notices(), ElementsAre(HasSubstr("only read")));
  EXPECT_TRUE(memory.tables.landmarks.find("book").has_value());
}

TEST(MemoryFile, AnOlderVersionIsBackedUpAndMigrated) {
  for (const Access access : {Access::session, Access::read}) {
    const Folder folder;
    const std::string file = folder / "home.db";
    {
      Opened memory(file, Access::session);
      add_landmark(memory.tables, "book", 1);
    }
    Opened memory(file, with_next_version(access));
    EXPECT_THAT(memory.file.notices(),
                ElementsAre(AllOf(HasSubstr("from version 1 to 2"), HasSubstr("v1.backup"))));
    EXPECT_EQ(memory.file.database().execAndGet("PRAGMA user_version").getInt(), 2);
    EXPECT_EQ(memory.file.database().execAndGet("SELECT colour FROM landmark").getString(), "");
    EXPECT_EQ(memory.file.database().execAndGet("SELECT version FROM migration").getInt(), 2);
    Opened backup(file + ".v1.backup", Access::read);
    EXPECT_TRUE(backup.tables.landmarks.find("book").has_value());
  }
}

TEST(MemoryFile, AMigrationThatFailsLeavesTheFileAsItWas) {
  const Folder folder;
  const std::string file = folder / "home.db";
  {
    Opened memory(file, Access::session);
    add_landmark(memory.tables, "book", 1);
  }
  const schema::Step bad = {2,
                            "UPDATE landmark SET name = 'gone'; ALTER TABLE absent ADD COLUMN x"};
  MemoryOptions given = options(Access::session);
  given.version = 2;
  given.steps = {&bad, 1};
  EXPECT_THAT(sentence_of([&] { Opened(file, given); }), HasSubstr("no such table"));
  given.steps = {};
  EXPECT_THAT(sentence_of([&] { Opened(file, given); }), HasSubstr("no way from it to version 2"));
  Opened memory(file, Access::session);
  EXPECT_TRUE(memory.tables.landmarks.find("book").has_value());
}

}  // namespace
}  // namespace striate::memory::memory_tests
