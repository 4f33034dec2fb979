#include "striate/base/shell_text.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <string>

namespace striate {
namespace {

TEST(ShellWord, StaysAsItIsWhereAShellReadsNothingInIt) {
  for (const char* word : {"config/worlds/corridor_a.yaml", "a-b_c.9", "tcp:host:9400", "--x=1"}) {
    EXPECT_EQ(shell_word(word), word);
  }
}

TEST(ShellWord, AShellTakesItForOneWordAgain) {
  for (const std::string word :
       {"", "my memory.db", "it's", "$HOME", "a;b", "`id`", "\"", "~x", "*", "a\\b", "!!", "#",
        "(x)", "a&b", "l\xC3\xA4\xC3\xB6", "'", "''", "-n", "two\nlines"}) {
    const std::string command = "set x " + shell_word(word) + "; printf '%s:%s' \"$#\" \"$2\"";
    FILE* shell = popen(command.c_str(), "r");
    ASSERT_NE(shell, nullptr);
    std::array<char, 256> said{};
    const std::size_t count = fread(said.data(), 1, said.size(), shell);
    pclose(shell);
    EXPECT_EQ(std::string(said.data(), count), "2:" + word);
  }
}

}  // namespace
}  // namespace striate
