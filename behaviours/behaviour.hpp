#pragma once

#include "behaviours/wish.hpp"
#include "memory/short_term_memory.hpp"

namespace striate {

/// A closed loop over memory. It never touches the motors and never reads sonar or laser.
class Behaviour {
 public:
  Behaviour() = default;
  virtual ~Behaviour() = default;
  Behaviour(const Behaviour&) = delete;
  Behaviour& operator=(const Behaviour&) = delete;

  /// Called before the first tick, and again when the behaviour is run anew.
  virtual void start(const ShortTermMemory& memory) = 0;
  /// Once a cycle, until it has succeeded, failed or been halted. Allocates nothing.
  virtual Wish tick(const ShortTermMemory& memory) = 0;
  /// Asks to end; called each cycle until it is true: the behaviour stands halted.
  virtual bool halt(const ShortTermMemory& /*memory*/) { return true; }
};

}  // namespace striate
