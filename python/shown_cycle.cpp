#include "striate/python/shown_cycle.hpp"

#include <stdexcept>

#include "striate/behaviours/control/arbiter.hpp"
#include "striate/behaviours/control/safety_limiter.hpp"

namespace striate::python {

ShownCycle::ShownCycle(const agent::Mission& mission)
    : mission_(&mission),
      senses_(without_images(mission.cycle().trace().senses)),
      loan_(std::make_unique<MemoryLoan>(mission.cycle().memory())) {
  const agent::CycleTrace& trace = mission.cycle().trace();
  number = mission.cycles();
  percept = seen_of(trace.percept);
  wish = trace.wish;
  sent = trace.sent;
  driver = behaviours::name_of(trace.driver);
  if (trace.limited_by != behaviours::LimitReason::none) {
    limited_by = behaviours::name_of(trace.limited_by);
  }
  action = mission.executive().current_action();
  doing = agent::doing_text(trace.wish.why, trace.limited_by);
  hold = mission.hold();
  waits_for_reset = mission.waits_for_reset();
  progress_m = mission.cycle().memory().progress_m();
}

void ShownCycle::end() {
  mission_ = nullptr;
  loan_->lent()->end();
}

const agent::Mission& ShownCycle::mission() const {
  if (mission_ != nullptr) return *mission_;
  throw std::runtime_error("this cycle is over: ask it while the callback runs");
}

SharedSenses ShownCycle::senses() {
  if (mission_ != nullptr && !with_images_) {
    senses_ = copied(mission_->cycle().trace().senses);
    with_images_ = true;
  }
  return senses_;
}

}  // namespace striate::python
