#include "striate/base/named_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

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

}  // namespace
}  // namespace striate
