#include <gtest/gtest.h>

#include "striate/config/yaml.hpp"
#include "striate/tasks/condition_reader.hpp"
#include "striate/tasks/condition_registry.hpp"

namespace striate::tasks {
namespace {

std::unique_ptr<Condition> condition(const std::string& yaml) {
  config::Diagnostics diagnostics("t.yaml", 'T');
  auto made = read_condition(config::parse_yaml(yaml, diagnostics), diagnostics);
  EXPECT_TRUE(diagnostics.none()) << diagnostics.text();
  return made;
}

class ConditionTest : public testing::Test {
 protected:
  /// A tenth of a second in which the robot drives with this speed.
  void cycle(double forward_m_s) {
    now_ += std::chrono::milliseconds(100);
    senses_.now = now_;
    senses_.odometry.forward_m_s = forward_m_s;
    senses_.odometry.pose.x_m += 0.1 * forward_m_s;
    memory_.update(senses_, percept_);
  }
  memory::ShortTermMemory memory_{memory::ShortTermMemorySettings{}, RobotDescription{}};
  Senses senses_;
  perception::Percept percept_;
  TimePoint now_{};
};

TEST_F(ConditionTest, EveryExampleCanBeRead) {
  for (const ConditionEntry& entry : condition_registry()) {
    EXPECT_TRUE(condition(entry.name + ": " + entry.example)) << entry.name;
  }
}

TEST_F(ConditionTest, TheChargeIsJudgedByTheVoltage) {
  const auto low = condition("battery_below: 20 %");
  cycle(0.0);
  EXPECT_FALSE(low->holds(memory_)) << "a body that does not tell counts as full";
  senses_.battery_v = 11.3;
  cycle(0.0);
  EXPECT_FALSE(low->holds(memory_));
  senses_.battery_v = 11.1;
  cycle(0.0);
  EXPECT_TRUE(low->holds(memory_));
}

TEST_F(ConditionTest, AnImageThatNeverCameIsOld) {
  const auto old = condition("image_older_than: 250 ms");
  cycle(0.0);
  EXPECT_TRUE(old->holds(memory_));
  percept_.valid = true;
  percept_.stamp = now_;
  cycle(0.0);
  EXPECT_FALSE(old->holds(memory_));
  for (int i = 0; i < 3; ++i) cycle(0.0);
  EXPECT_TRUE(old->holds(memory_));
}

TEST_F(ConditionTest, StandingCountsFromTheLastMotion) {
  const auto stands = condition("stands_for: 1 s");
  cycle(0.3);
  stands->start(memory_);
  for (int i = 0; i < 20; ++i) {
    cycle(0.3);
    EXPECT_FALSE(stands->holds(memory_));
  }
  for (int i = 1; i < 10; ++i) {
    cycle(0.0);
    EXPECT_FALSE(stands->holds(memory_)) << i;
  }
  cycle(0.0);
  EXPECT_TRUE(stands->holds(memory_));
}

TEST_F(ConditionTest, AnUnmeasuredCorridorIsNeitherWideNorNarrow) {
  cycle(0.0);
  EXPECT_FALSE(condition("corridor_wider_than: 1 m")->holds(memory_));
  EXPECT_FALSE(condition("corridor_narrower_than: 90 m")->holds(memory_));
}

TEST_F(ConditionTest, TheWayBackIsCountedDown) {
  const auto home = condition("progress_below: 0.5 m");
  for (int i = 0; i < 40; ++i) cycle(0.5);
  EXPECT_FALSE(home->holds(memory_));
  for (int i = 0; i < 38; ++i) cycle(-0.5);
  EXPECT_TRUE(home->holds(memory_));
}

}  // namespace
}  // namespace striate::tasks
