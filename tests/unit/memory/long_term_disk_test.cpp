#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "striate/memory/long_term/damage.hpp"
#include "striate/memory/long_term/memory_errors.hpp"
#include "tests/unit/memory/long_term_fixtures.hpp"

namespace striate::memory::memory_tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

/// As whom permissions hold; the superuser may write everywhere.
class AsNobody {
 public:
  AsNobody() : superuser_(geteuid() == 0) {
    if (superuser_) is_ = seteuid(65534) == 0;
  }
  ~AsNobody() {
    if (superuser_) is_ = seteuid(0) == 0;
  }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;

 private:
  bool superuser_;
  bool is_ = true;
};

TEST(MemoryFile, AReadOnlyFolderCanBeReadAndSaysWhyItCannotBeWritten) {
  const Folder folder;
  const std::string file = folder / "home.db";
  {
    Opened memory(file, Access::session);
    add_landmark(memory.tables, "book", 1);
  }
  chmod(file.c_str(), 0444);
  chmod(folder.path().c_str(), 0555);
  {
    const AsNobody nobody;
    Opened memory(file, Access::read);
    EXPECT_TRUE(memory.tables.landmarks.find("book").has_value());
    EXPECT_THAT(sentence_of([&] { Opened(file, Access::session); }),
                AllOf(HasSubstr("it cannot be written"), HasSubstr("writable")));
    EXPECT_THAT(sentence_of([&] {
                  Opened edit(file, Access::edit);
                  try {
                    edit.tables.landmarks.update(*edit.tables.landmarks.find("book"));
                  } catch (const SQLite::Exception& error) {
                    throw_memory_error(file, "changing it", error);
                  }
                }),
                HasSubstr("writable"));
  }
  chmod(folder.path().c_str(), 0755);
}

TEST(MemoryFile, AFullDiskLosesNothingThatWasAcknowledged) {
  const Folder folder;
  const std::string file = folder / "home.db";
  MemoryOptions given = options(Access::session);
  given.most_pages = 40;
  int kept = 0;
  {
    MemoryWriter writer(file, given);
    std::string sentence;
    for (unsigned k = 0; sentence.empty() && k < 500; ++k) {
      sentence = sentence_of([&] {
        writer.commit([k](MemoryTables& tables) {
          add_landmark(tables, "thing " + std::to_string(k), k, 200);
        });
        ++kept;
      });
    }
    EXPECT_THAT(sentence, AllOf(HasSubstr("there is no room left"), HasSubstr("free some")));
    writer.post([](MemoryTables& tables) {
      for (int k = 0; k < 2000; ++k) {
        Episode episode;
        episode.kind = "start";
        episode.text = std::string(1000, 'x');
        tables.sessions.add(episode);
      }
    });
    EXPECT_NE(sentence_of([&] {
                writer.commit([](MemoryTables& tables) { add_landmark(tables, "more", 9, 2000); });
              }),
              "");
    EXPECT_EQ(writer.lost(), 1U);
    EXPECT_THAT(writer.why_lost(), HasSubstr("there is no room left"));
  }
  ASSERT_GT(kept, 3);
  Opened memory(file, Access::session);
  EXPECT_EQ(memory.tables.landmarks.all(true).size(), static_cast<std::size_t>(kept));
  EXPECT_THAT(find_damage(memory.file.database()), IsEmpty());
}

}  // namespace
}  // namespace striate::memory::memory_tests
