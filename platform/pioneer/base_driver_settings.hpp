#pragma once

#include "striate/platform/pioneer/safety_gate_settings.hpp"
#include "striate/platform/pioneer/session_settings.hpp"

namespace striate::pioneer {

struct BaseDriverSettings {
  SessionSettings session;
  SafetyGateSettings gate;
};

template <class V>
void visit(V& v, BaseDriverSettings& s) {
  v.section("session", s.session);
  v.section("gate", s.gate);
}

}  // namespace striate::pioneer
