#pragma once

#include <cstdint>

#include "striate/base/fixed_text.hpp"
#include "striate/behaviours/control/failure.hpp"
#include "striate/memory/short_term/short_term_memory.hpp"

namespace striate::behaviours {

enum class Progress : std::uint8_t { running, succeeded, failed };

/// A reason in words, in fixed memory.
using ShortText = FixedText<95>;

/// What a behaviour wants in this cycle. A lease: it lapses kWishLease after `stamp`.
struct Wish {
  double forward_m_s = 0.0;
  double turn_rad_s = 0.0;
  double pan_rad = 0.0;
  double tilt_rad = 0.0;
  Progress progress = Progress::running;
  Failure failure = Failure::other;  ///< where it has failed
  ShortText why;    ///< in words for a person: what it does, or why it stands or failed
  TimePoint stamp;  ///< when it was wished
};

/// A wish of now: stand, look ahead and a little down.
[[nodiscard]] inline Wish standing_wish(const memory::ShortTermMemory& memory, ShortText why) {
  Wish wish;
  wish.tilt_rad = memory.robot().resting_tilt_rad;
  wish.why = why;
  wish.stamp = memory.now();
  return wish;
}

[[nodiscard]] inline Wish final_wish(const memory::ShortTermMemory& memory, Progress progress,
                                     ShortText why) {
  Wish wish = standing_wish(memory, why);
  wish.progress = progress;
  return wish;
}

/// The end of an action that did not come to what it was after.
[[nodiscard]] inline Wish failed_wish(const memory::ShortTermMemory& memory, Failure failure,
                                      ShortText why) {
  Wish wish = final_wish(memory, Progress::failed, why);
  wish.failure = failure;
  return wish;
}

}  // namespace striate::behaviours
