#include "striate/base/plain_text.hpp"

#include <gtest/gtest.h>

namespace striate {
namespace {

TEST(PlainText, IsWhatEveryTerminalShowsAsItIs) {
  for (const char* good : {"", "red book", "rotes Büchlein", "本", "😀", "a\\xFF", "naïve – ok"}) {
    EXPECT_TRUE(is_plain_text(good)) << good;
    EXPECT_EQ(plain_text(good), good);
  }
}

TEST(PlainText, WritesOutWhatIsNotShown) {
  const std::pair<std::string, std::string> cases[] = {
      {"a\xFF"
       "b",
       "a\\xFFb"},                                   // no UTF-8
      {"\xC3", "\\xC3"},                             // cut off
      {"\xC0\xAF", "\\xC0\\xAF"},                    // a slash, written too long
      {"\xED\xA0\x80", "\\xED\\xA0\\x80"},           // half of a pair of UTF-16
      {"\xF4\x90\x80\x80", "\\xF4\\x90\\x80\\x80"},  // beyond Unicode
      {"\x1B[2J", "\\u001B[2J"},                     // clears the screen
      {"\xC2\x9B"
       "2J",
       "\\u009B2J"},                    // the same by C1
      {"x\xE2\x80\xAEy", "x\\u202Ey"},  // turns the direction
      {"a\nb", "a\\u000Ab"},
      {std::string("a\0b", 3), "a\\u0000b"},
  };
  for (const auto& [text, plain] : cases) {
    EXPECT_FALSE(is_plain_text(text)) << plain;
    EXPECT_EQ(plain_text(text), plain);
    EXPECT_TRUE(is_plain_text(plain_text(text))) << plain;
  }
  EXPECT_NE(plain_text("a\xFE"), plain_text("a\xFF"));
}

TEST(PlainText, IsEscapedForXmlAndCsv) {
  EXPECT_EQ(xml_text("<a & \"b\">\x01"), "&lt;a &amp; &quot;b&quot;&gt;\\u0001");
  EXPECT_EQ(csv_cell("plain"), "plain");
  EXPECT_EQ(csv_cell("a, \"b\"\n"), "\"a, \"\"b\"\"\\u000A\"");
}

}  // namespace
}  // namespace striate
