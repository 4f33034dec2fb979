#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "striate/memory/short_term/short_term_memory.hpp"

namespace striate::memory {
namespace {

perception::Percept percept_at(int ms, double value) {
  perception::Percept percept;
  percept.valid = true;
  percept.stamp = TimePoint(std::chrono::milliseconds(ms));
  percept.figures.emplace_back().name = "stage.figure";
  percept.figures.back().value = value;
  return percept;
}

Senses senses_at(int ms) {
  Senses senses;
  senses.now = senses.odometry.stamp = TimePoint(std::chrono::milliseconds(ms));
  return senses;
}

TEST(Figures, AreThoseOfTheNewestImage) {
  ShortTermMemory memory({}, {});
  EXPECT_TRUE(std::isnan(memory.figure("stage.figure")));
  memory.update(senses_at(100), percept_at(100, 0.25));
  EXPECT_EQ(memory.figure("stage.figure"), 0.25);
  memory.update(senses_at(200), percept_at(200, 0.5));
  EXPECT_EQ(memory.figure("stage.figure"), 0.5);
  memory.update(senses_at(300), percept_at(150, 0.75));  // older than what is known
  EXPECT_EQ(memory.figure("stage.figure"), 0.5);
  EXPECT_TRUE(std::isnan(memory.figure("stage")));
}

}  // namespace
}  // namespace striate::memory
