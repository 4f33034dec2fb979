#pragma once

#include "platform/pioneer/base_driver_settings.hpp"
#include "platform/pioneer/safety_gate.hpp"
#include "platform/pioneer/session.hpp"
#include "platform/pioneer/transport.hpp"

namespace striate::pioneer {

/// Session, gate and transport as one: `step` every few 10 ms moves bytes and decides. No thread,
/// no clock; DriverThread gives it both.
class BaseDriver {
 public:
  BaseDriver(const BaseDriverSettings& settings, Transport& line)
      : session_(settings.session), gate_(settings.gate, session_), line_(line) {}

  void step(TimePoint now);
  /// Stop, motors off, CLOSE; the line is closed once `step` has been called again.
  void close() { session_.close(); }

  [[nodiscard]] Session& session() { return session_; }
  [[nodiscard]] const Session& session() const { return session_; }
  [[nodiscard]] SafetyGate& gate() { return gate_; }
  [[nodiscard]] const SafetyGate& gate() const { return gate_; }

 private:
  void care_for_the_line(TimePoint now);

  Session session_;
  SafetyGate gate_;
  Transport& line_;
  bool asked_to_open_ = false;
};

}  // namespace striate::pioneer
