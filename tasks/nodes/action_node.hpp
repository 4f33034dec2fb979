#pragma once

#include <memory>
#include <string>

#include "striate/tasks/nodes/task_node.hpp"

namespace striate::tasks {

/// A leaf: one behaviour. It is started once, ticked, and either ends by itself or is halted.
class ActionNode final : public TaskNode {
 public:
  /// @param line in the script, for reports.
  ActionNode(std::string name, int line, std::unique_ptr<behaviours::Behaviour> behaviour);

 protected:
  void on_start(TaskCycle& cycle) override { behaviour_->start(cycle.memory()); }
  NodeStatus on_tick(TaskCycle& cycle) override;
  bool on_halt(TaskCycle& cycle) override;

 private:
  std::string name_;
  int line_;
  std::unique_ptr<behaviours::Behaviour> behaviour_;
  behaviours::Motors motors_;
};

}  // namespace striate::tasks
