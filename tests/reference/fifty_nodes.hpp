#pragma once

#include "striate/tasks/nodes/limited_node.hpp"
#include "striate/tasks/nodes/only_if_node.hpp"
#include "striate/tasks/nodes/optional_node.hpp"
#include "striate/tasks/nodes/recover_node.hpp"
#include "striate/tasks/nodes/repeat_node.hpp"
#include "striate/tasks/nodes/sequence_node.hpp"
#include "striate/tasks/nodes/together_node.hpp"
#include "striate/tasks/nodes/try_node.hpp"
#include "striate/tasks/task.hpp"
#include "tests/reference/scripted_behaviour.hpp"

namespace striate::reference {

/// Runs for ever.
class Endless final : public behaviours::Behaviour {
 public:
  explicit Endless(behaviours::Motors motors) : motors_(motors) {}
  void start(const memory::ShortTermMemory&) override {}
  behaviours::Wish tick(const memory::ShortTermMemory& memory) override {
    return behaviours::standing_wish(memory, "runs");
  }
  [[nodiscard]] behaviours::Motors motors() const override { return motors_; }

 private:
  behaviours::Motors motors_;
};

/// A tree of 50 nodes of every kind that never ends and ticks every node in every cycle: a task of
/// one `together` of six branches, each a chain of eight.
struct FiftyNodes {
  static constexpr int kNodes = 2 + 6 * 8;
  tasks::Task task;

  FiftyNodes() {
    std::vector<tasks::NodePtr> branches;
    for (const behaviours::Motors motors :
         {behaviours::Motors::wheels, behaviours::Motors::head, behaviours::Motors::nothing,
          behaviours::Motors::nothing, behaviours::Motors::nothing, behaviours::Motors::nothing}) {
      branches.push_back(chain(motors));
    }
    std::vector<tasks::Guard> guards(1);
    guards[0].condition = std::make_unique<Never>();
    task.root = std::make_unique<tasks::ScopeNode>(
        std::move(guards), std::make_unique<tasks::TogetherNode>(std::move(branches)), nullptr);
  }

 private:
  class Never final : public tasks::Condition {
   public:
    [[nodiscard]] bool holds(const memory::ShortTermMemory& memory) const override {
      return memory.distance_travelled_m() > 1e9;
    }
  };

  static tasks::NodePtr chain(behaviours::Motors motors) {
    tasks::NodePtr node =
        std::make_unique<tasks::ActionNode>("endless", 1, std::make_unique<Endless>(motors));
    tasks::Limits limits;
    limits.until = std::make_unique<Never>();
    limits.within = std::chrono::hours(1);
    node = std::make_unique<tasks::LimitedNode>("endless", 1, std::move(node), std::move(limits));
    node = std::make_unique<tasks::RecoverNode>(
        std::move(node), std::make_unique<tasks::SequenceNode>(std::vector<tasks::NodePtr>{}), 1);
    node = std::make_unique<tasks::OptionalNode>(std::move(node));
    node = std::make_unique<tasks::OnlyIfNode>(std::move(node), nullptr, std::make_unique<Never>());
    node = std::make_unique<tasks::SequenceNode>(nodes(std::move(node)));
    node = std::make_unique<tasks::TryNode>(nodes(std::move(node)));
    return std::make_unique<tasks::RepeatNode>(std::move(node), 0);
  }
};

}  // namespace striate::reference
