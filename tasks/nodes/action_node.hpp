#pragma once

#include <memory>
#include <string>

#include "tasks/nodes/task_node.hpp"

namespace striate {

/// A leaf: one behaviour. It is started once, ticked, and either ends by itself or is halted.
class ActionNode final : public TaskNode {
 public:
  /// @param line in the script, for reports.
  ActionNode(std::string name, int line, std::unique_ptr<Behaviour> behaviour);

 protected:
  void on_start(TaskCycle& cycle) override { behaviour_->start(cycle.memory()); }
  Outcome on_tick(TaskCycle& cycle) override;
  bool on_halt(TaskCycle& cycle) override;

 private:
  std::string name_;
  int line_;
  std::unique_ptr<Behaviour> behaviour_;
  Motors motors_;
};

}  // namespace striate
