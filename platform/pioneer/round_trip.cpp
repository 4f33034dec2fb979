#include "striate/platform/pioneer/round_trip.hpp"

#include <algorithm>

namespace striate::pioneer {
namespace {

/// Two SIP cycles: below half of what a command may be old
constexpr Duration kAskAgain = std::chrono::milliseconds(200);
/// A SIP of 93 ms at 9600 baud, question and answer: so three may be lost within half a second
constexpr Duration kAskOther = std::chrono::milliseconds(150);
/// No answer of any kind for so long: lost, all of them; five times the robot's watchdog
constexpr Duration kAllLost = std::chrono::seconds(10);

}  // namespace

void RoundTrip::begin(TimePoint now) {
  questions_.clear();
  measured_.reset();
  asked_ = false;
  asked_at_ = now;
}

std::optional<RoundTrip::Question> RoundTrip::asks(TimePoint now) {
  const Duration pause = questions_.newest() ? kAskOther : kAskAgain;
  if (asked_ && now - asked_at_ < pause) return std::nullopt;
  if (const auto newest = questions_.newest(); newest && now - *newest > kAllLost) {
    questions_.clear();
  }
  // Two alike could not be told apart: a lost answer is found by asking something else.
  const auto* next = std::find_if(
      kAll.begin(), kAll.end(), [&](Question question) { return !questions_.waits_for(question); });
  if (next == kAll.end()) return std::nullopt;
  questions_.ask(*next, now);
  asked_ = true;
  asked_at_ = now;
  return *next;
}

void RoundTrip::answered(Question question, TimePoint now) {
  if (const auto asked = questions_.answer(question)) {
    measured_ = std::max(Duration{}, now - *asked);
  }
}

std::optional<Duration> RoundTrip::delay(TimePoint now) const {
  if (!measured_) return std::nullopt;
  const auto oldest = questions_.oldest();
  return oldest ? std::max(*measured_, now - *oldest) : *measured_;
}

}  // namespace striate::pioneer
