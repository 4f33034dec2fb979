#pragma once

#include <cstdint>
#include <memory>

#include "striate/tasks/nodes/task_cycle.hpp"

namespace striate::tasks {

/// How a node came out. `skipped`: its `only_if` did not hold, so it was neither good nor bad.
enum class NodeStatus : std::uint8_t { running, succeeded, failed, skipped };

/// How a node stands, to be shown: before its first run, in a run, or how the last one came out.
enum class NodeState : std::uint8_t { waiting, running, succeeded, failed, skipped, halted };

/// A node of a task's tree, with the semantics of behaviour trees: it is ticked once a cycle until
/// it ends, or is halted. It starts with the first tick and may be run again after its end.
/// Kinds derive and implement the three on_ functions; the order of calls is kept here.
/// Nothing below allocates.
class TaskNode {
 public:
  TaskNode() = default;
  virtual ~TaskNode() = default;
  TaskNode(const TaskNode&) = delete;
  TaskNode& operator=(const TaskNode&) = delete;

  /// Starts it without a tick, for what may be halted before its first one. Nothing if it runs.
  void begin(TaskCycle& cycle);
  /// One cycle; begins it where it does not run. @throws std::logic_error while it is being halted.
  NodeStatus tick(TaskCycle& cycle);
  /// Asks to end; called each cycle until true: everything below stands halted. True at once where
  /// nothing runs. What two nodes above ask in one cycle is passed on once.
  bool halt(TaskCycle& cycle);
  [[nodiscard]] bool runs() const { return state_ != State::idle; }
  /// For who looks on; nothing is decided by it.
  [[nodiscard]] NodeState shown() const { return runs() ? NodeState::running : last_; }

 protected:
  /// Once before the first tick of each run. Children start with their own first tick.
  virtual void on_start(TaskCycle& /*cycle*/) {}
  virtual NodeStatus on_tick(TaskCycle& cycle) = 0;
  /// Only while it runs. True: nothing below runs any more.
  virtual bool on_halt(TaskCycle& cycle) = 0;

 private:
  enum class State : std::uint8_t { idle, running, halting };
  State state_ = State::idle;
  NodeState last_ = NodeState::waiting;  ///< how the last run came out
  long asked_to_halt_in_ = 0;            ///< number of the cycle
};

using NodePtr = std::unique_ptr<TaskNode>;

}  // namespace striate::tasks
