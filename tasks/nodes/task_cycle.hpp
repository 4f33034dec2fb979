#pragma once

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "behaviours/behaviour.hpp"
#include "memory/short_term_memory.hpp"
#include "platform/interface/time.hpp"

namespace striate {

/// Why something failed, in words; fixed memory, what is too long is cut.
class Reason {
 public:
  template <class... Args>
  void set(fmt::format_string<Args...> text, Args&&... args) {
    const auto end =
        fmt::format_to_n(text_.data(), text_.size(), text, std::forward<Args>(args)...);
    size_ = std::min(end.size, text_.size());
  }
  void clear() { size_ = 0; }
  [[nodiscard]] std::string_view view() const { return {text_.data(), size_}; }

 private:
  std::array<char, 240> text_{};
  std::size_t size_ = 0;
};

/// One cycle of a task: what its nodes look at, and the one wish that they make together.
class TaskCycle {
 public:
  /// @param number of the cycle, from 1 on.
  TaskCycle(const ShortTermMemory& memory, TimePoint now, Reason& reason, long number)
      : memory_(memory),
        now_(now),
        reason_(reason),
        number_(number),
        wish_(standing_wish(memory, "")) {}

  [[nodiscard]] const ShortTermMemory& memory() const { return memory_; }
  [[nodiscard]] TimePoint now() const { return now_; }
  [[nodiscard]] long number() const { return number_; }
  [[nodiscard]] Reason& reason() { return reason_; }

  /// An action that runs wants these motors. @throws std::logic_error where another one has them
  /// in this cycle: the checker lets no such script through.
  void want(const void* action, std::string_view name, Motors motors, const Wish& wanted);
  /// The action takes back what it wanted in this cycle, because it is halted.
  void release(const void* action);
  /// A guard holds the robot still in this cycle.
  void pause(const char* why);

  [[nodiscard]] const Wish& wish() const { return wish_; }
  /// The action that has the wheels, or else the last that ran; "" when none did.
  [[nodiscard]] std::string_view doing() const { return doing_; }
  [[nodiscard]] bool paused() const { return paused_; }

 private:
  const ShortTermMemory& memory_;
  TimePoint now_;
  Reason& reason_;
  long number_;
  Wish wish_;
  const void* wheels_of_ = nullptr;
  const void* head_of_ = nullptr;
  std::string_view doing_;
  bool paused_ = false;
};

}  // namespace striate
