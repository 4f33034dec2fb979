#include "striate/tasks/executive.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "striate/tasks/nodes/limited_node.hpp"
#include "striate/tasks/nodes/only_if_node.hpp"
#include "striate/tasks/nodes/optional_node.hpp"
#include "striate/tasks/nodes/recover_node.hpp"
#include "striate/tasks/nodes/repeat_node.hpp"
#include "striate/tasks/nodes/sequence_node.hpp"
#include "striate/tasks/nodes/together_node.hpp"
#include "striate/tasks/nodes/try_node.hpp"
#include "tests/reference/scripted_behaviour.hpp"

namespace striate::tasks {
namespace {

using reference::AfterLooks;
using reference::Log;
using reference::nodes;
using reference::Script;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<Guard> guard(Guard::Kind kind, std::unique_ptr<Condition> condition) {
  std::vector<Guard> guards(1);
  guards[0].kind = kind;
  guards[0].text = "looked: often";
  guards[0].line = 3;
  guards[0].condition = std::move(condition);
  return guards;
}

/// Holds from one look to another.
class Between final : public Condition {
 public:
  Between(int from, int to) : from_(from), to_(to) {}
  [[nodiscard]] bool holds(const memory::ShortTermMemory&) const override {
    ++looks_;
    return looks_ > from_ && looks_ <= to_;
  }

 private:
  int from_;
  int to_;
  mutable int looks_ = 0;
};

class ExecutiveTest : public testing::Test {
 protected:
  NodePtr act(Script script) { return reference::action(std::move(script), log_); }

  template <class... Nodes>
  static NodePtr sequence(Nodes... each) {
    return std::make_unique<SequenceNode>(nodes(std::move(each)...));
  }
  template <class... Nodes>
  static NodePtr finally(Nodes... each) {
    return std::make_unique<SequenceNode>(nodes(std::move(each)...), true);
  }
  static NodePtr until(NodePtr child, int looks) {
    Limits limits;
    limits.until = std::make_unique<AfterLooks>(looks);
    return std::make_unique<LimitedNode>("a", 7, std::move(child), std::move(limits));
  }
  static NodePtr within_1s(NodePtr child) {
    Limits limits;
    limits.within = std::chrono::seconds(1);
    return std::make_unique<LimitedNode>("a", 7, std::move(child), std::move(limits));
  }
  static Task task(NodePtr steps, NodePtr at_the_end = nullptr, std::vector<Guard> guards = {}) {
    Task task;
    task.root =
        std::make_unique<ScopeNode>(std::move(guards), std::move(steps), std::move(at_the_end));
    return task;
  }

  /// Ticks until the end, at most `limit` cycles of 100 ms; counts the cycles that drove.
  void run(Executive& executive, int limit = 200) {
    for (int i = 0; i < limit && !executive.ended(); ++i) {
      now_ += std::chrono::milliseconds(100);
      const behaviours::Claim claim = executive.tick(memory_, now_).claim;
      driven_ += claim.wish.forward_m_s > 0.0 ? 1 : 0;
      guarded_ += claim.owner == behaviours::MotorOwner::guard ? 1 : 0;
    }
    EXPECT_TRUE(executive.ended());
  }
  void run(Task task) {
    Executive executive(std::move(task));
    run(executive);
    state_ = executive.state();
    reason_ = executive.reason();
  }

  Log log_;
  memory::ShortTermMemory memory_{memory::ShortTermMemorySettings{}, RobotDescription{}};
  TimePoint now_{};
  int driven_ = 0;
  int guarded_ = 0;
  MissionState state_ = MissionState::running;
  std::string reason_;
};

TEST_F(ExecutiveTest, RunsStepsInOrderAndThenFinally) {
  run(task(sequence(act({"a", 2}), act({"b", 3})), finally(act({"f", 1}))));
  EXPECT_EQ(state_, MissionState::succeeded);
  EXPECT_THAT(log_, ElementsAre("start a", "end a", "start b", "end b", "start f", "end f"));
  EXPECT_EQ(driven_, 6);
}

TEST_F(ExecutiveTest, NodesShowHowTheyStandAndHowTheyCameOut) {
  NodePtr first = until(act({"a", 100}), 4);
  NodePtr second = act({"b", 3, behaviours::Progress::failed});
  NodePtr third = act({"c", 1});
  const TaskNode* nodes[] = {first.get(), second.get(), third.get()};
  Executive executive(task(sequence(std::move(first), std::move(second), std::move(third))));
  EXPECT_EQ(nodes[0]->shown(), NodeState::waiting);
  executive.tick(memory_, now_);
  EXPECT_EQ(nodes[0]->shown(), NodeState::running);
  EXPECT_EQ(nodes[1]->shown(), NodeState::waiting);
  run(executive);
  EXPECT_EQ(nodes[0]->shown(), NodeState::succeeded);
  EXPECT_EQ(nodes[1]->shown(), NodeState::failed);
  EXPECT_EQ(nodes[2]->shown(), NodeState::waiting);
}

TEST_F(ExecutiveTest, UntilHaltsTheActionBeforeTheNextStarts) {
  run(task(sequence(until(act({"a", 100, behaviours::Progress::failed, 3}), 4), act({"b", 1}))));
  EXPECT_EQ(state_, MissionState::succeeded);
  EXPECT_THAT(log_, ElementsAre("start a", "halted a", "start b", "end b"));
  EXPECT_EQ(driven_, 4 + 1);
}

TEST_F(ExecutiveTest, WithinFailsTheMissionAndStillRunsFinally) {
  run(task(sequence(within_1s(act({"a", 1000})), act({"never", 1})),
           finally(act({"f", 1, behaviours::Progress::failed}), act({"g", 1}))));
  EXPECT_EQ(state_, MissionState::failed);
  EXPECT_THAT(reason_, HasSubstr("a (line 7) took longer than 1 s"));
  EXPECT_THAT(log_, ElementsAre("start a", "halted a", "start f", "end f", "start g", "end g"));
}

TEST_F(ExecutiveTest, AFailureIsRecoveredAndTriedAgainAsOftenAsAllowed) {
  run(task(sequence(
      std::make_unique<RecoverNode>(act({"a", 1, behaviours::Progress::failed}),
                                    finally(act({"r", 1, behaviours::Progress::failed})), 2))));
  EXPECT_EQ(state_, MissionState::failed);
  EXPECT_THAT(reason_, HasSubstr("a (line 7): scripted"));
  EXPECT_THAT(log_, ElementsAre("start a", "end a", "start r", "end r", "start a", "end a",
                                "start r", "end r", "start a", "end a"));
}

TEST_F(ExecutiveTest, AnInterruptionHaltsThenRunsFinallyAndNothingDrivesWhileHalting) {
  Executive executive(
      task(sequence(act({"a", 1000, behaviours::Progress::succeeded, 5})), finally(act({"f", 1}))));
  for (int i = 0; i < 3; ++i) executive.tick(memory_, now_);
  executive.interrupt(MissionState::interrupted, "Ctrl-C");
  run(executive);
  EXPECT_EQ(executive.state(), MissionState::interrupted);
  EXPECT_EQ(executive.reason(), "Ctrl-C");
  EXPECT_THAT(log_, ElementsAre("start a", "halted a", "start f", "end f"));
  EXPECT_EQ(driven_, 1);
}

TEST_F(ExecutiveTest, AnInterruptionBeforeTheFirstCycleStillRunsFinally) {
  Executive executive(task(sequence(act({"a", 5})), finally(act({"f", 1}))));
  executive.interrupt(MissionState::interrupted, "Ctrl-C");
  run(executive);
  EXPECT_THAT(log_, ElementsAre("start f", "end f"));
}

TEST_F(ExecutiveTest, AnInterruptionDuringRecoveryHaltsTheRecovery) {
  Executive executive(task(sequence(std::make_unique<RecoverNode>(
      act({"a", 0, behaviours::Progress::failed}), finally(act({"r", 1000})), 1))));
  for (int i = 0; i < 3; ++i) executive.tick(memory_, now_);
  executive.interrupt(MissionState::interrupted, "Ctrl-C");
  run(executive);
  EXPECT_THAT(log_, ElementsAre("start a", "end a", "start r", "halted r"));
}

TEST_F(ExecutiveTest, AFinallyThatNeverEndsIsHalted) {
  Executive executive(task(sequence(act({"a", 1})), finally(act({"f", 1000000}))));
  run(executive, 400);
  EXPECT_EQ(executive.state(), MissionState::succeeded);
  EXPECT_THAT(log_, ElementsAre("start a", "end a", "start f", "halted f"));
}

TEST_F(ExecutiveTest, TryTakesTheFirstThatWorks) {
  run(task(std::make_unique<TryNode>(
      nodes(act({"a", 1, behaviours::Progress::failed}), act({"b", 1}), act({"c", 1})))));
  EXPECT_EQ(state_, MissionState::succeeded);
  EXPECT_EQ(reason_, "");
  EXPECT_THAT(log_, ElementsAre("start a", "end a", "start b", "end b"));
}

TEST_F(ExecutiveTest, TryFailsWhenAllFail) {
  run(task(std::make_unique<TryNode>(nodes(act({"a", 1, behaviours::Progress::failed}),
                                           act({"b", 0, behaviours::Progress::failed})))));
  EXPECT_EQ(state_, MissionState::failed);
  EXPECT_THAT(reason_, HasSubstr("b (line 7)"));
}

TEST_F(ExecutiveTest, TogetherMovesWheelsAndHeadAndWaitsForBoth) {
  Executive executive(task(std::make_unique<TogetherNode>(
      nodes(act({"w", 3, behaviours::Progress::succeeded, 0, behaviours::Motors::wheels}),
            act({"h", 1, behaviours::Progress::succeeded, 0, behaviours::Motors::head})))));
  behaviours::Wish wish = executive.tick(memory_, now_).claim.wish;
  EXPECT_EQ(wish.forward_m_s, 0.3);
  EXPECT_EQ(wish.pan_rad, 0.5);
  EXPECT_EQ(executive.current_action(), "w");
  wish = executive.tick(memory_, now_).claim.wish;
  EXPECT_EQ(wish.forward_m_s, 0.3);
  EXPECT_EQ(wish.pan_rad, 0.0);
  run(executive);
  EXPECT_EQ(executive.state(), MissionState::succeeded);
  EXPECT_THAT(log_, ElementsAre("start w", "start h", "end h", "end w"));
}

TEST_F(ExecutiveTest, TogetherHaltsTheOthersWhenOneFails) {
  run(task(std::make_unique<TogetherNode>(
      nodes(act({"w", 30, behaviours::Progress::succeeded, 4, behaviours::Motors::wheels}),
            act({"h", 1, behaviours::Progress::failed, 0, behaviours::Motors::head})))));
  EXPECT_EQ(state_, MissionState::failed);
  EXPECT_THAT(log_, ElementsAre("start w", "start h", "end h", "halted w"));
}

TEST_F(ExecutiveTest, TwoThatWantTheSameMotorsAreABug) {
  Executive executive(task(std::make_unique<TogetherNode>(nodes(act({"a", 3}), act({"b", 3})))));
  EXPECT_THROW(executive.tick(memory_, now_), std::logic_error);
}

TEST_F(ExecutiveTest, RepeatCountsItsRoundsAndStartsEachAnew) {
  run(task(std::make_unique<RepeatNode>(sequence(act({"a", 1})), 3)));
  EXPECT_EQ(state_, MissionState::succeeded);
  EXPECT_THAT(log_, ElementsAre("start a", "end a", "start a", "end a", "start a", "end a"));
}

TEST_F(ExecutiveTest, ARepeatForEverIsEndedByUntil) {
  run(task(until(std::make_unique<RepeatNode>(sequence(act({"a", 1})), 0), 4)));
  EXPECT_EQ(state_, MissionState::succeeded);
  EXPECT_THAT(log_, ElementsAre("start a", "end a", "start a", "end a", "start a", "halted a"));
}

TEST_F(ExecutiveTest, WhatIsNotWantedIsSkippedInTheSameCycle) {
  const auto never = [this](const char* name) {
    return std::make_unique<OnlyIfNode>(act({name, 1}), std::make_unique<AfterLooks>(100), nullptr);
  };
  const auto unless = [this](const char* name) {
    return std::make_unique<OnlyIfNode>(act({name, 1}), nullptr, std::make_unique<AfterLooks>(0));
  };
  run(task(sequence(never("a"), unless("b"), act({"c", 1}),
                    std::make_unique<TryNode>(nodes(never("d"), act({"e", 1}))))));
  EXPECT_EQ(state_, MissionState::succeeded);
  EXPECT_THAT(log_, ElementsAre("start c", "end c", "start e", "end e"));
}

TEST_F(ExecutiveTest, AnOptionalFailureIsNone) {
  run(task(sequence(std::make_unique<OptionalNode>(act({"a", 1, behaviours::Progress::failed})),
                    act({"b", 1}))));
  EXPECT_EQ(state_, MissionState::succeeded);
}

TEST_F(ExecutiveTest, APauseHoldsTheRobotStillAndTheActionGoesOnAfterIt) {
  run(task(sequence(act({"a", 6})), nullptr,
           guard(Guard::Kind::pause_if, std::make_unique<Between>(3, 8))));
  EXPECT_EQ(state_, MissionState::succeeded);
  EXPECT_EQ(driven_, 6);
  EXPECT_EQ(guarded_, 5);
  EXPECT_THAT(log_, ElementsAre("start a", "end a"));
}

TEST_F(ExecutiveTest, AGuardThatFailsHaltsAndRunsFinally) {
  run(task(sequence(act({"a", 1000, behaviours::Progress::succeeded, 2})), finally(act({"f", 1})),
           guard(Guard::Kind::fail_if, std::make_unique<AfterLooks>(3))));
  EXPECT_EQ(state_, MissionState::failed);
  EXPECT_EQ(reason_, "guard (line 3): looked: often");
  EXPECT_THAT(log_, ElementsAre("start a", "halted a", "start f", "end f"));
}

TEST_F(ExecutiveTest, AUsedTaskRunsItsOwnFinallyAlsoWhenItIsInterrupted) {
  NodePtr used = std::make_unique<ScopeNode>(std::vector<Guard>{}, sequence(act({"a", 1000})),
                                             finally(act({"g", 2})));
  Executive executive(task(sequence(std::move(used)), finally(act({"f", 1}))));
  for (int i = 0; i < 3; ++i) executive.tick(memory_, now_);
  executive.interrupt(MissionState::interrupted, "Ctrl-C");
  run(executive);
  EXPECT_THAT(log_, ElementsAre("start a", "halted a", "start g", "end g", "start f", "end f"));
}

}  // namespace
}  // namespace striate::tasks
