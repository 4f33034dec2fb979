#pragma once

#include "striate/platform/pioneer/base_driver_settings.hpp"
#include "striate/platform/pioneer/safety_gate.hpp"
#include "striate/platform/pioneer/session.hpp"
#include "striate/platform/pioneer/transport.hpp"

namespace striate::pioneer {

/// ArcosSession, gate and transport as one: `step` every few 10 ms moves bytes and decides. No
/// thread, no clock; DriverThread gives it both.
class BaseDriver {
 public:
  BaseDriver(const BaseDriverSettings& settings, Transport& line)
      : session_(settings.session), gate_(settings.gate, session_), line_(line) {}

  void step(TimePoint now);
  /// Stop, motors off, CLOSE; the line is closed once `step` has been called again.
  void close() { session_.close(); }

  [[nodiscard]] ArcosSession& session() { return session_; }
  [[nodiscard]] const ArcosSession& session() const { return session_; }
  [[nodiscard]] SafetyGate& gate() { return gate_; }
  [[nodiscard]] const SafetyGate& gate() const { return gate_; }

 private:
  void care_for_the_line(TimePoint now);

  ArcosSession session_;
  SafetyGate gate_;
  Transport& line_;
  bool asked_to_open_ = false;
};

}  // namespace striate::pioneer
