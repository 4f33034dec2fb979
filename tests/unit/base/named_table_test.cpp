#include "striate/base/named_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>

namespace striate {
namespace {

struct Entry {
  std::string name;
  int value = 0;
};

TEST(NamedTable, RefusesANameThatIsTakenAndKeepsTheFirst) {
  NamedTable<Entry> table({{"a", 1}, {"b", 2}});
  EXPECT_FALSE(table.add({"b", 3}));
  EXPECT_EQ(table.size(), 2U);
  EXPECT_EQ(table.find("b")->value, 2);
  EXPECT_EQ(table.find("c"), nullptr);
}

TEST(NamedTable, AnEntryStaysWhereItIsWhenMoreAreAdded) {
  NamedTable<Entry> table({{"a", 1}});
  const Entry* a = table.find("a");
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(table.add({std::to_string(i), i}));
  EXPECT_EQ(table.find("a"), a);
  EXPECT_EQ(table.begin()->name, "a");
}

// Under the thread sanitizer, which sees what happens to go well.
TEST(NamedTable, IsSearchedAndGoneThroughWhileOthersAddToIt) {
  constexpr int kAdded = 2000;  // many blocks of a deque
  NamedTable<Entry> table({{"a", 1}});
  std::atomic<bool> done = false;
  std::thread adds([&] {
    for (int i = 0; i < kAdded; ++i) EXPECT_TRUE(table.add({std::to_string(i), i}));
    done = true;
  });
  do {
    EXPECT_EQ(table.find("a")->value, 1);
    int next = -1;
    for (const Entry& entry : table) {
      if (next >= 0) {
        EXPECT_EQ(entry.value, next);
      }
      ++next;
    }
  } while (!done);
  adds.join();
  EXPECT_EQ(table.size(), static_cast<std::size_t>(kAdded) + 1);
}

}  // namespace
}  // namespace striate
