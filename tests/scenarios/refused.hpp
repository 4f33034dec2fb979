#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/scenarios/striate_here.hpp"

/// What the command line refuses.
namespace striate::scenarios {

using Words = std::vector<std::string>;

inline Words with(Words words, const std::string& last) {
  words.push_back(last);
  return words;
}

/// Exit code 2, nothing on standard output, and on standard error at least what `says` has.
struct Row {
  Words words;
  std::string says;
};

inline void expect_refused(const std::vector<Row>& rows) {
  for (const Row& row : rows) {
    const Ended ended = striate_here(row.words);
    EXPECT_EQ(ended.exit_code, 2) << testing::PrintToString(row.words) << ended.err;
    EXPECT_THAT(ended.err, testing::HasSubstr(row.says)) << testing::PrintToString(row.words);
    EXPECT_THAT(ended.out, testing::IsEmpty()) << testing::PrintToString(row.words);
  }
}

}  // namespace striate::scenarios
