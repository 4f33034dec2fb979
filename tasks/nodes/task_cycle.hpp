#pragma once

#include <string_view>
#include <utility>

#include "striate/base/format_text.hpp"
#include "striate/base/time.hpp"
#include "striate/behaviours/control/behaviour.hpp"
#include "striate/memory/short_term/short_term_memory.hpp"

namespace striate::tasks {

/// Why something failed: a word for programs, the line of the script, and words for people in fixed
/// memory; what is too long is cut.
class Reason {
 public:
  template <class... Args>
  void set(behaviours::Failure failure, int line, fmt::format_string<Args...> text,
           Args&&... args) {
    failure_ = failure;
    line_ = line;
    text_ = format_text<FixedText<240>>(text, std::forward<Args>(args)...);
  }
  [[nodiscard]] std::string_view view() const { return text_.view(); }
  [[nodiscard]] behaviours::Failure failure() const { return failure_; }
  /// From 1 on; 0: nothing has failed.
  [[nodiscard]] int line() const { return line_; }

 private:
  behaviours::Failure failure_ = behaviours::Failure::other;
  int line_ = 0;
  FixedText<240> text_;
};

/// One cycle of a task: what its nodes look at, and the one wish that they make together.
class TaskCycle {
 public:
  /// @param number of the cycle, from 1 on.
  TaskCycle(const memory::ShortTermMemory& memory, TimePoint now, Reason& reason, long number)
      : memory_(memory),
        now_(now),
        reason_(reason),
        number_(number),
        wish_(behaviours::standing_wish(memory, "")) {}

  [[nodiscard]] const memory::ShortTermMemory& memory() const { return memory_; }
  [[nodiscard]] TimePoint now() const { return now_; }
  [[nodiscard]] long number() const { return number_; }
  [[nodiscard]] Reason& reason() { return reason_; }

  /// An action that runs wants these motors. @throws std::logic_error where another one has them
  /// in this cycle: the checker lets no such script through.
  void want(const void* action, std::string_view name, behaviours::Motors motors,
            const behaviours::Wish& wanted);
  /// The action takes back what it wanted in this cycle, because it is halted.
  void release(const void* action);
  /// A guard holds the robot still in this cycle.
  void pause(const char* why);

  [[nodiscard]] const behaviours::Wish& wish() const { return wish_; }
  /// The action that has the wheels, or else the last that ran; "" when none did.
  [[nodiscard]] std::string_view doing() const { return doing_; }
  [[nodiscard]] bool paused() const { return paused_; }

 private:
  const memory::ShortTermMemory& memory_;
  TimePoint now_;
  Reason& reason_;
  long number_;
  behaviours::Wish wish_;
  const void* wheels_of_ = nullptr;
  const void* head_of_ = nullptr;
  std::string_view doing_;
  bool paused_ = false;
};

}  // namespace striate::tasks
