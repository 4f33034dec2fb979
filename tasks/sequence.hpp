#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tasks/task.hpp"

namespace striate {

/// How a sequence or step stands.
enum class Outcome { running, succeeded, failed };

/// Runs steps one after the other. An action is started once, ticked, and either ends by itself
/// or is halted, over several cycles if it needs them, before anything else starts.
class Sequence {
 public:
  /// `keep_going`: a failed step does not end the sequence (for `finally`).
  explicit Sequence(std::vector<Step>& steps, bool keep_going = false)
      : steps_(steps), keep_going_(keep_going) {}

  /// One cycle. The wish is stop where no action runs. Once ended it stays ended.
  Outcome tick(const ShortTermMemory& memory, TimePoint now, Wish& wish);

  /// Halts whatever runs; true once it stands halted.
  bool halt(const ShortTermMemory& memory, Wish& wish);

  [[nodiscard]] const std::string& reason() const { return reason_; }
  /// The action that has the motors now, for the status line; "" between actions.
  [[nodiscard]] std::string current_action() const;

 private:
  enum class Phase { idle, acting, halting, recovering };

  void begin_step(const ShortTermMemory& memory, TimePoint now);
  void act(const ShortTermMemory& memory, TimePoint now, Wish& wish);
  void end_step(Outcome outcome);

  std::vector<Step>& steps_;
  bool keep_going_;
  std::size_t index_ = 0;
  Phase phase_ = Phase::idle;
  TimePoint started_;
  int tries_ = 0;
  Outcome pending_ = Outcome::running;  ///< what the step will have been once it is halted
  Outcome outcome_ = Outcome::running;
  std::string reason_;
  std::unique_ptr<Sequence> recovery_;
};

}  // namespace striate
