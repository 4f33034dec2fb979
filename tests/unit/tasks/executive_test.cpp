#include "tasks/executive.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace striate {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Log = std::vector<std::string>;

/// Notes what is done to it, runs for some ticks, and may need several cycles to halt.
class Scripted final : public Behaviour {
 public:
  struct Script {
    std::string name;
    int ticks = 1;
    Progress ends_as = Progress::succeeded;
    int halt_cycles = 0;
  };
  Scripted(Script script, Log& log) : script_(std::move(script)), log_(log) {}

  void start(const ShortTermMemory&) override {
    log_.push_back("start " + script_.name);
    left_ = script_.ticks;
    halts_ = 0;
  }
  Wish tick(const ShortTermMemory& memory) override {
    if (--left_ < 0) return final_wish(memory, script_.ends_as, "scripted");
    Wish wish = standing_wish(memory, "driving");
    wish.forward_m_s = 0.3;
    return wish;
  }
  bool halt(const ShortTermMemory&) override {
    if (halts_++ < script_.halt_cycles) return false;
    log_.push_back("halted " + script_.name);
    return true;
  }

 private:
  Script script_;
  Log& log_;
  int left_ = 0;
  int halts_ = 0;
};

class AfterTicks final : public Condition {
 public:
  explicit AfterTicks(int ticks) : left_(ticks) {}
  [[nodiscard]] bool holds(const ShortTermMemory&) const override { return --left_ < 0; }

 private:
  mutable int left_;
};

class ExecutiveTest : public testing::Test {
 protected:
  Step step(Scripted::Script script) {
    Step step;
    step.action = script.name;
    step.place = {7, 3};
    step.behaviour = std::make_unique<Scripted>(std::move(script), log_);
    return step;
  }

  /// Ticks until the end, at most `limit` cycles of 100 ms; counts the cycles that drove.
  void run(Executive& executive, int limit = 200) {
    for (int i = 0; i < limit && !executive.ended(); ++i) {
      now_ += std::chrono::milliseconds(100);
      const Wish wish = executive.tick(memory_, now_);
      driven_ += wish.forward_m_s > 0.0 ? 1 : 0;
    }
    EXPECT_TRUE(executive.ended());
  }

  Log log_;
  ShortTermMemory memory_{ShortTermMemorySettings{}, RobotDescription{}};
  TimePoint now_{};
  int driven_ = 0;
};

TEST_F(ExecutiveTest, RunsStepsInOrderAndThenFinally) {
  Task task;
  task.steps.push_back(step({"a", 2}));
  task.steps.push_back(step({"b", 3}));
  task.finally.push_back(step({"f", 1}));
  Executive executive(std::move(task));
  run(executive);
  EXPECT_EQ(executive.state(), MissionState::succeeded);
  EXPECT_THAT(log_, ElementsAre("start a", "start b", "start f"));
  EXPECT_EQ(driven_, 6);
}

TEST_F(ExecutiveTest, UntilHaltsTheActionBeforeTheNextStarts) {
  Task task;
  task.steps.push_back(step({"a", 100, Progress::failed, 3}));
  task.steps.back().until = std::make_unique<AfterTicks>(4);
  task.steps.push_back(step({"b", 1}));
  Executive executive(std::move(task));
  run(executive);
  EXPECT_EQ(executive.state(), MissionState::succeeded);
  EXPECT_THAT(log_, ElementsAre("start a", "halted a", "start b"));
  EXPECT_EQ(driven_, 4 + 1);
}

TEST_F(ExecutiveTest, WithinFailsTheMissionAndStillRunsFinally) {
  Task task;
  task.steps.push_back(step({"a", 1000}));
  task.steps.back().within = std::chrono::seconds(1);
  task.steps.push_back(step({"never", 1}));
  task.finally.push_back(step({"f", 1, Progress::failed}));
  task.finally.push_back(step({"g", 1}));
  Executive executive(std::move(task));
  run(executive);
  EXPECT_EQ(executive.state(), MissionState::failed);
  EXPECT_THAT(executive.reason(), HasSubstr("a (line 7) took longer than 1 s"));
  EXPECT_THAT(log_, ElementsAre("start a", "halted a", "start f", "start g"));
}

TEST_F(ExecutiveTest, AFailureIsRecoveredAndTriedAgainAsOftenAsAllowed) {
  Task task;
  task.steps.push_back(step({"a", 1, Progress::failed}));
  auto recovery = std::make_unique<Recovery>();
  recovery->tries = 2;
  recovery->steps.push_back(step({"r", 1}));
  task.steps.back().if_it_fails = std::move(recovery);
  Executive executive(std::move(task));
  run(executive);
  EXPECT_EQ(executive.state(), MissionState::failed);
  EXPECT_THAT(executive.reason(), HasSubstr("scripted"));
  EXPECT_THAT(log_, ElementsAre("start a", "start r", "start a", "start r", "start a"));
}

TEST_F(ExecutiveTest, AnInterruptionHaltsThenRunsFinallyAndNothingDrivesWhileHalting) {
  Task task;
  task.steps.push_back(step({"a", 1000, Progress::succeeded, 5}));
  task.finally.push_back(step({"f", 1}));
  Executive executive(std::move(task));
  for (int i = 0; i < 3; ++i) executive.tick(memory_, now_);
  executive.interrupt(MissionState::interrupted, "Ctrl-C");
  run(executive);
  EXPECT_EQ(executive.state(), MissionState::interrupted);
  EXPECT_EQ(executive.reason(), "Ctrl-C");
  EXPECT_THAT(log_, ElementsAre("start a", "halted a", "start f"));
  EXPECT_EQ(driven_, 1);
}

TEST_F(ExecutiveTest, AnInterruptionDuringRecoveryHaltsTheRecovery) {
  Task task;
  task.steps.push_back(step({"a", 0, Progress::failed}));
  auto recovery = std::make_unique<Recovery>();
  recovery->steps.push_back(step({"r", 1000}));
  task.steps.back().if_it_fails = std::move(recovery);
  Executive executive(std::move(task));
  for (int i = 0; i < 3; ++i) executive.tick(memory_, now_);
  executive.interrupt(MissionState::interrupted, "Ctrl-C");
  run(executive);
  EXPECT_THAT(log_, ElementsAre("start a", "start r", "halted r"));
}

TEST_F(ExecutiveTest, AFinallyThatNeverEndsIsHalted) {
  Task task;
  task.steps.push_back(step({"a", 1}));
  task.finally.push_back(step({"f", 1000000}));
  Executive executive(std::move(task));
  run(executive, 400);
  EXPECT_EQ(executive.state(), MissionState::succeeded);
  EXPECT_THAT(log_, ElementsAre("start a", "start f", "halted f"));
}

}  // namespace
}  // namespace striate
