#pragma once

#include "tasks/nodes/limited_node.hpp"
#include "tasks/nodes/only_if_node.hpp"
#include "tasks/nodes/optional_node.hpp"
#include "tasks/nodes/recover_node.hpp"
#include "tasks/nodes/repeat_node.hpp"
#include "tasks/nodes/sequence_node.hpp"
#include "tasks/nodes/together_node.hpp"
#include "tasks/nodes/try_node.hpp"
#include "tasks/task.hpp"
#include "tests/reference/scripted_behaviour.hpp"

namespace striate::reference {

/// Runs for ever.
class Endless final : public Behaviour {
 public:
  explicit Endless(Motors motors) : motors_(motors) {}
  void start(const ShortTermMemory&) override {}
  Wish tick(const ShortTermMemory& memory) override { return standing_wish(memory, "runs"); }
  [[nodiscard]] Motors motors() const override { return motors_; }

 private:
  Motors motors_;
};

/// A tree of 50 nodes of every kind that never ends and ticks every node in every cycle: a task of
/// one `together` of six branches, each a chain of eight.
struct FiftyNodes {
  static constexpr int kNodes = 2 + 6 * 8;
  Task task;

  FiftyNodes() {
    std::vector<NodePtr> branches;
    for (const Motors motors : {Motors::wheels, Motors::head, Motors::nothing, Motors::nothing,
                                Motors::nothing, Motors::nothing}) {
      branches.push_back(chain(motors));
    }
    std::vector<Guard> guards(1);
    guards[0].condition = std::make_unique<Never>();
    task.root = std::make_unique<ScopeNode>(
        std::move(guards), std::make_unique<TogetherNode>(std::move(branches)), nullptr);
  }

 private:
  class Never final : public Condition {
   public:
    [[nodiscard]] bool holds(const ShortTermMemory& memory) const override {
      return memory.distance_travelled_m() > 1e9;
    }
  };

  static NodePtr chain(Motors motors) {
    NodePtr node = std::make_unique<ActionNode>("endless", 1, std::make_unique<Endless>(motors));
    Limits limits;
    limits.until = std::make_unique<Never>();
    limits.within = std::chrono::hours(1);
    node = std::make_unique<LimitedNode>("endless", 1, std::move(node), std::move(limits));
    node = std::make_unique<RecoverNode>(std::move(node),
                                         std::make_unique<SequenceNode>(std::vector<NodePtr>{}), 1);
    node = std::make_unique<OptionalNode>(std::move(node));
    node = std::make_unique<OnlyIfNode>(std::move(node), nullptr, std::make_unique<Never>());
    node = std::make_unique<SequenceNode>(nodes(std::move(node)));
    node = std::make_unique<TryNode>(nodes(std::move(node)));
    return std::make_unique<RepeatNode>(std::move(node), 0);
  }
};

}  // namespace striate::reference
