#include "striate/base/instruction_set.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/reference/every_target.hpp"

namespace striate {
namespace {

using testing::AnyOf;
using testing::Each;
using testing::ElementsAre;
using testing::Not;
using testing::StartsWith;

std::vector<std::string> tested_instruction_sets() {
  std::vector<std::string> names;
  reference::on_every_target([&](const std::string& name) {
    EXPECT_EQ(instruction_set(), name);
    names.push_back(name);
  });
  return names;
}

/// "Every instruction set" of the other tests is what they say, and none is left out.
TEST(InstructionSet, EveryOneThatIsTestedIsTheOneThatRuns) {
  const std::string usual(instruction_set());
  RecordProperty("instruction_set", usual);
  const std::vector<std::string> names = tested_instruction_sets();
  ASSERT_FALSE(names.empty());
  EXPECT_EQ(names.front(), usual) << "the best comes first";
  EXPECT_EQ(instruction_set(), usual) << "all is as before";
#if defined(__aarch64__)
  EXPECT_THAT(names, ElementsAre("NEON"));
#elif defined(__x86_64__)
  EXPECT_THAT(names.back(), AnyOf("SCALAR", "EMU128"));  // as the compiler has it
#endif
}

/// qemu and newer processors have SVE, which the vector code is not built for: it is not told.
TEST(InstructionSet, IsNoneThatTheVectorCodeWasNotBuiltFor) {
  EXPECT_THAT(tested_instruction_sets(), Each(Not(StartsWith("SVE"))));
}

}  // namespace
}  // namespace striate
