#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "striate/tasks/condition.hpp"
#include "striate/tasks/nodes/action_node.hpp"

/// Behaviours and conditions that do what a test says, and note what is done to them.
namespace striate::reference {

using Log = std::vector<std::string>;

struct Script {
  std::string name;
  int ticks = 1;  ///< so many before it ends
  behaviours::Progress ends_as = behaviours::Progress::succeeded;
  int halt_cycles = 0;  ///< how often it is asked to halt before it has
  behaviours::Motors motors = behaviours::Motors::both;
};

class Scripted final : public behaviours::Behaviour {
 public:
  Scripted(Script script, Log& log) : script_(std::move(script)), log_(log) {}

  void start(const memory::ShortTermMemory&) override {
    log_.push_back("start " + script_.name);
    left_ = script_.ticks;
    halts_ = 0;
  }
  behaviours::Wish tick(const memory::ShortTermMemory& memory) override {
    if (--left_ < 0) {
      log_.push_back("end " + script_.name);
      return behaviours::final_wish(memory, script_.ends_as, "scripted");
    }
    behaviours::Wish wish = behaviours::standing_wish(memory, "driving");
    wish.forward_m_s = 0.3;
    wish.pan_rad = 0.5;
    return wish;
  }
  bool halt(const memory::ShortTermMemory&) override {
    if (halts_++ < script_.halt_cycles) return false;
    log_.push_back("halted " + script_.name);
    return true;
  }
  [[nodiscard]] behaviours::Motors motors() const override { return script_.motors; }

 private:
  Script script_;
  Log& log_;
  int left_ = 0;
  int halts_ = 0;
};

/// Holds from the n-th look after its start on.
class AfterLooks final : public tasks::Condition {
 public:
  explicit AfterLooks(int looks) : looks_(looks), left_(looks) {}
  void start(const memory::ShortTermMemory&) override { left_ = looks_; }
  [[nodiscard]] bool holds(const memory::ShortTermMemory&) const override { return --left_ < 0; }

 private:
  int looks_;
  mutable int left_;
};

inline tasks::NodePtr action(Script script, Log& log) {
  const std::string name = script.name;
  return std::make_unique<tasks::ActionNode>(name, 7,
                                             std::make_unique<Scripted>(std::move(script), log));
}

template <class... Nodes>
std::vector<tasks::NodePtr> nodes(Nodes... each) {
  std::vector<tasks::NodePtr> list;
  (list.push_back(std::move(each)), ...);
  return list;
}

}  // namespace striate::reference
