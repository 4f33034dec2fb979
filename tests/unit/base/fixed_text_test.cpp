#include "striate/base/fixed_text.hpp"

#include <gtest/gtest.h>

#include <string>

#include "striate/base/format_text.hpp"

namespace striate {
namespace {

TEST(FixedText, CutsWhatIsTooLong) {
  const FixedText<5> text("corridor");
  EXPECT_EQ(text.view(), "corri");
  EXPECT_STREQ(text.c_str(), "corri");
  EXPECT_TRUE(FixedText<5>().empty());
}

TEST(FixedText, TextsAreEqualByWhatTheySay) {
  FixedText<7> text("a longer one");
  text = "book";
  EXPECT_EQ(text, FixedText<7>("book")) << "nothing of the longer text is left";
  EXPECT_FALSE(text == FixedText<7>("books"));
  text.clear();
  EXPECT_TRUE(text.empty());
}

TEST(FormatText, FormatsAndCuts) {
  EXPECT_EQ(format_text<FixedText<31>>("{:.1f} m to '{}'", 2.25, "cup").view(), "2.2 m to 'cup'");
  EXPECT_EQ(format_text<FixedText<4>>("{}", 1234567).view(), "1234");
}

}  // namespace
}  // namespace striate
