#include "tasks/sequence.hpp"

#include <fmt/format.h>

namespace striate {

Outcome Sequence::tick(const ShortTermMemory& memory, TimePoint now, Wish& wish) {
  wish = standing_wish(memory, "");
  if (outcome_ != Outcome::running) return outcome_;
  if (index_ >= steps_.size()) return outcome_ = Outcome::succeeded;
  switch (phase_) {
    case Phase::idle:
      begin_step(memory, now);
      [[fallthrough]];
    case Phase::acting:
      act(memory, now, wish);
      break;
    case Phase::halting:
      if (steps_[index_].behaviour->halt(memory)) end_step(pending_);
      break;
    case Phase::recovering:
      // However the recovery ends, the step is tried again; only its own tries are counted.
      if (recovery_->tick(memory, now, wish) != Outcome::running) {
        recovery_.reset();
        phase_ = Phase::idle;
      }
      break;
  }
  if (outcome_ == Outcome::running && index_ >= steps_.size()) outcome_ = Outcome::succeeded;
  return outcome_;
}

void Sequence::begin_step(const ShortTermMemory& memory, TimePoint now) {
  Step& step = steps_[index_];
  step.behaviour->start(memory);
  if (step.until) step.until->start(memory);
  started_ = now;
  phase_ = Phase::acting;
}

void Sequence::act(const ShortTermMemory& memory, TimePoint now, Wish& wish) {
  Step& step = steps_[index_];
  const Wish wanted = step.behaviour->tick(memory);
  if (wanted.progress == Progress::succeeded) return end_step(Outcome::succeeded);
  if (wanted.progress == Progress::failed) {
    reason_ = fmt::format("{} (line {}): {}", step.action, step.place.line, wanted.why.view());
    return end_step(Outcome::failed);
  }
  if (step.until && step.until->holds(memory)) {
    pending_ = Outcome::succeeded;
  } else if (step.within && now - started_ > *step.within) {
    reason_ = fmt::format("{} (line {}) took longer than {:g} s", step.action, step.place.line,
                          to_seconds(*step.within));
    pending_ = Outcome::failed;
  } else {
    wish = wanted;
    return;
  }
  phase_ = Phase::halting;
  if (step.behaviour->halt(memory)) end_step(pending_);
}

void Sequence::end_step(Outcome outcome) {
  Step& step = steps_[index_];
  phase_ = Phase::idle;
  if (outcome == Outcome::failed && step.if_it_fails && tries_ < step.if_it_fails->tries) {
    ++tries_;
    recovery_ = std::make_unique<Sequence>(step.if_it_fails->steps, true);
    phase_ = Phase::recovering;
    return;
  }
  if (outcome == Outcome::failed && !keep_going_) {
    outcome_ = Outcome::failed;
    return;
  }
  tries_ = 0;
  ++index_;
}

bool Sequence::halt(const ShortTermMemory& memory, Wish& wish) {
  wish = standing_wish(memory, "");
  if (outcome_ != Outcome::running) return true;
  if (phase_ == Phase::recovering && !recovery_->halt(memory, wish)) return false;
  if (phase_ == Phase::acting || phase_ == Phase::halting) {
    phase_ = Phase::halting;
    if (!steps_[index_].behaviour->halt(memory)) return false;
  }
  phase_ = Phase::idle;
  outcome_ = Outcome::failed;
  return true;
}

std::string Sequence::current_action() const {
  if (outcome_ != Outcome::running || index_ >= steps_.size()) return "";
  if (phase_ == Phase::recovering) return recovery_->current_action();
  return steps_[index_].action;
}

}  // namespace striate
