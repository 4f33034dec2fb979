#pragma once

#include <cstdint>

#include "striate/behaviours/control/wish.hpp"
#include "striate/memory/short_term/short_term_memory.hpp"

namespace striate::behaviours {

/// What a behaviour moves. Two that run together must not want the same.
enum class Motors : std::uint8_t { nothing = 0, wheels = 1, head = 2, both = 3 };

[[nodiscard]] constexpr Motors operator|(Motors a, Motors b) {
  return static_cast<Motors>(static_cast<unsigned>(a) | static_cast<unsigned>(b));
}
[[nodiscard]] constexpr bool share(Motors a, Motors b) {
  return (static_cast<unsigned>(a) & static_cast<unsigned>(b)) != 0;
}

/// A closed loop over memory. It never touches the motors and never reads sonar or laser.
class Behaviour {
 public:
  Behaviour() = default;
  virtual ~Behaviour() = default;
  Behaviour(const Behaviour&) = delete;
  Behaviour& operator=(const Behaviour&) = delete;

  /// Called before the first tick, and again when the behaviour is run anew.
  virtual void start(const memory::ShortTermMemory& memory) = 0;
  /// Once a cycle, until it has succeeded, failed or been halted. Allocates nothing.
  virtual Wish tick(const memory::ShortTermMemory& memory) = 0;
  /// Asks to end; called each cycle until it is true: the behaviour stands halted.
  virtual bool halt(const memory::ShortTermMemory& /*memory*/) { return true; }

  // What the checker of task scripts wants to know; constant from construction on.
  /// What its wishes move; the rest of a wish counts only where nothing else runs.
  [[nodiscard]] virtual Motors motors() const { return Motors::both; }
  /// False: it goes on until it is halted or fails, so nothing after it is reached without `until`.
  [[nodiscard]] virtual bool ends_by_itself() const { return true; }
  /// False: it always succeeds, so what would follow its failure is never reached.
  [[nodiscard]] virtual bool can_fail() const { return true; }
};

}  // namespace striate::behaviours
