#include <gtest/gtest.h>

#include <map>
#include <random>

#include "striate/tasks/executive.hpp"
#include "striate/tasks/nodes/limited_node.hpp"
#include "striate/tasks/nodes/only_if_node.hpp"
#include "striate/tasks/nodes/optional_node.hpp"
#include "striate/tasks/nodes/recover_node.hpp"
#include "striate/tasks/nodes/repeat_node.hpp"
#include "striate/tasks/nodes/sequence_node.hpp"
#include "striate/tasks/nodes/together_node.hpp"
#include "striate/tasks/nodes/try_node.hpp"
#include "tests/reference/scripted_behaviour.hpp"

/// What must hold for every tree, tried on random ones.
namespace striate::tasks {
namespace {

/// What all actions of one run do, and what they must not.
struct Watch {
  struct Seen {
    behaviours::Motors motors = behaviours::Motors::nothing;
    int started = 0;
    int ended = 0;  ///< by itself or halted
  };
  std::vector<Seen> actions;
  int now_running = 0;

  [[nodiscard]] bool runs(std::size_t i) const { return actions[i].started > actions[i].ended; }
  void started(std::size_t me) {
    EXPECT_FALSE(runs(me)) << "started twice";
    for (std::size_t i = 0; i < actions.size(); ++i) {
      EXPECT_FALSE(i != me && runs(i) && behaviours::share(actions[i].motors, actions[me].motors))
          << "started before the one that had its motors was halted";
    }
    ++actions[me].started;
  }
  void ended(std::size_t me) {
    EXPECT_TRUE(runs(me)) << "ended twice";
    ++actions[me].ended;
  }
};

class Watched final : public behaviours::Behaviour {
 public:
  Watched(Watch& watch, std::size_t me, std::mt19937& random)
      : watch_(watch), me_(me), random_(random) {}
  void start(const memory::ShortTermMemory&) override {
    watch_.started(me_);
    left_ = static_cast<int>(random_() % 6);
    halts_left_ = static_cast<int>(random_() % 4);
    halting_ = false;
  }
  behaviours::Wish tick(const memory::ShortTermMemory& memory) override {
    EXPECT_TRUE(watch_.runs(me_) && !halting_);
    if (--left_ >= 0) return behaviours::standing_wish(memory, "runs");
    watch_.ended(me_);
    const bool good = random_() % 3 != 0;
    return behaviours::final_wish(
        memory, good ? behaviours::Progress::succeeded : behaviours::Progress::failed, "ended");
  }
  bool halt(const memory::ShortTermMemory&) override {
    halting_ = true;
    if (--halts_left_ >= 0) return false;
    watch_.ended(me_);
    return true;
  }
  [[nodiscard]] behaviours::Motors motors() const override { return watch_.actions[me_].motors; }

 private:
  Watch& watch_;
  std::size_t me_;
  std::mt19937& random_;
  int left_ = 0;
  int halts_left_ = 0;
  bool halting_ = false;
};

class Chance final : public Condition {
 public:
  Chance(std::mt19937& random, unsigned one_in) : random_(random), one_in_(one_in) {}
  [[nodiscard]] bool holds(const memory::ShortTermMemory&) const override {
    return random_() % one_in_ == 0;
  }

 private:
  std::mt19937& random_;
  unsigned one_in_;
};

class RandomTree {
 public:
  explicit RandomTree(unsigned seed) : random_(seed) {}

  /// A task with `finally`; its first step and its last action are noted, for each must run.
  NodePtr scope(int depth, behaviours::Motors motors) {
    const std::size_t first = actions_made();
    std::vector<NodePtr> steps;
    steps.push_back(action(motors));
    steps.push_back(any(depth, motors));
    std::vector<NodePtr> at_the_end;
    const std::size_t last = actions_made();
    at_the_end.push_back(action(motors));
    at_the_end.push_back(action(motors));
    scopes_.emplace_back(first, last);
    std::vector<Guard> guards(random_() % 3);
    for (Guard& guard : guards) {
      guard.kind = random_() % 2 == 0 ? Guard::Kind::pause_if : Guard::Kind::fail_if;
      guard.condition = chance(guard.kind == Guard::Kind::pause_if ? 4 : 60);
    }
    return std::make_unique<ScopeNode>(std::move(guards),
                                       std::make_unique<SequenceNode>(std::move(steps)),
                                       std::make_unique<SequenceNode>(std::move(at_the_end), true));
  }

  void check() const {
    for (const Watch::Seen& action : watch_.actions) EXPECT_EQ(action.started, action.ended);
    for (const auto& [first, last] : scopes_) {
      EXPECT_GE(watch_.actions[last].started, watch_.actions[first].started) << "no finally";
    }
    EXPECT_GE(watch_.actions[scopes_.back().second].started, 1) << "the mission's finally";
  }
  [[nodiscard]] int started() const {
    int sum = 0;
    for (const Watch::Seen& action : watch_.actions) sum += action.started;
    return sum;
  }
  std::mt19937& random() { return random_; }

 private:
  [[nodiscard]] std::size_t actions_made() const { return watch_.actions.size(); }
  std::unique_ptr<Condition> chance(unsigned one_in) {
    return std::make_unique<Chance>(random_, one_in);
  }
  NodePtr action(behaviours::Motors motors) {
    const std::size_t me = actions_made();
    watch_.actions.push_back({motors, 0, 0});
    return std::make_unique<ActionNode>("action", static_cast<int>(me),
                                        std::make_unique<Watched>(watch_, me, random_));
  }
  std::vector<NodePtr> several(int depth, behaviours::Motors motors) {
    std::vector<NodePtr> list(1 + random_() % 4);
    for (NodePtr& child : list) child = any(depth, motors);
    return list;
  }
  NodePtr limited(int depth, behaviours::Motors motors) {
    Limits limits;
    if (random_() % 2 == 0) limits.until = chance(5);
    if (random_() % 2 == 0) limits.within = std::chrono::milliseconds(random_() % 1500);
    return std::make_unique<LimitedNode>("limited", 1, any(depth, motors), std::move(limits));
  }
  NodePtr together(int depth, behaviours::Motors motors) {
    std::vector<NodePtr> list;
    if (motors == behaviours::Motors::both) {
      list.push_back(any(depth, behaviours::Motors::head));
      motors = behaviours::Motors::wheels;
    }
    list.push_back(any(depth, motors));
    list.push_back(any(depth, behaviours::Motors::nothing));
    return std::make_unique<TogetherNode>(std::move(list));
  }
  NodePtr any(int depth, behaviours::Motors motors) {
    if (depth-- == 0) return action(motors);
    switch (random_() % 10) {
      case 0:
        return std::make_unique<SequenceNode>(several(depth, motors));
      case 1:
        return std::make_unique<SequenceNode>(several(depth, motors), true);
      case 2:
        return std::make_unique<TryNode>(several(depth, motors));
      case 3:
        return together(depth, motors);
      case 4:
        return std::make_unique<RepeatNode>(any(depth, motors),
                                            1 + static_cast<int>(random_() % 3));
      case 5:
        return limited(depth, motors);
      case 6:
        return std::make_unique<RecoverNode>(any(depth, motors), any(depth, motors), 2);
      case 7:
        return std::make_unique<OnlyIfNode>(any(depth, motors), chance(2), nullptr);
      case 8:
        return std::make_unique<OptionalNode>(any(depth, motors));
      default:
        return scope(depth, motors);
    }
  }

  std::mt19937 random_;
  Watch watch_;
  std::vector<std::pair<std::size_t, std::size_t>> scopes_;
};

TEST(RandomTrees, HaltBeforeTheyStartEndWhatTheyStartedAndRunFinally) {
  const memory::ShortTermMemory memory({}, {});
  long started = 0;
  int interrupted = 0;
  for (unsigned seed = 1; seed <= 10000 && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE(seed);
    RandomTree tree(seed);
    Task task;
    NodePtr root = tree.scope(1 + static_cast<int>(seed % 5), behaviours::Motors::both);
    task.root.reset(static_cast<ScopeNode*>(root.release()));
    Executive executive(std::move(task));
    const int interrupt_at = seed % 2 == 0 ? static_cast<int>(tree.random()() % 60) : 100000;
    TimePoint now{};
    for (int cycle = 0; cycle < 200000 && !executive.ended(); ++cycle) {
      if (cycle == interrupt_at) executive.interrupt(MissionState::interrupted, "Ctrl-C");
      now += std::chrono::milliseconds(100);
      ASSERT_NO_THROW(executive.tick(memory, now));
    }
    ASSERT_TRUE(executive.ended());
    interrupted += executive.state() == MissionState::interrupted ? 1 : 0;
    started += tree.started();
    tree.check();
  }
  EXPECT_GT(started, 30000);
  EXPECT_GT(interrupted, 1000);
}

}  // namespace
}  // namespace striate::tasks
