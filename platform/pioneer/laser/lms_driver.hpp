#pragma once

#include "striate/platform/pioneer/laser/laser_driver.hpp"
#include "striate/platform/pioneer/laser/lms200.hpp"
#include "striate/platform/pioneer/questions.hpp"

namespace striate::pioneer {

enum class LmsStep { begin, variant, install, unit, start, scan, closed };

/// A SICK LMS-200: sets it up (180 degrees in whole degrees, millimetres, on request), asks for one
/// scan after the other, and begins again when it falls silent. Its telegrams have no stamps and
/// those of a laser that sends by itself may be any age; one that was asked for is younger than the
/// question.
class LmsDriver : public LaserDriver<LmsStep, lms200::TelegramStream> {
 public:
  explicit LmsDriver(const LaserSettings& settings) : LaserDriver(settings) {}

  /// The line is a new one: no scan is on its way.
  void line_up() { questions_.clear(); }
  void receive(ByteView bytes, TimePoint now);
  void tick(TimePoint now);
  /// The laser measures on request only, which nobody makes.
  void close();

 private:
  using Step = LmsStep;
  void take(const lms200::Telegram& telegram, TimePoint now);
  void take_scan(const lms200::Telegram& telegram, TimePoint asked_at, TimePoint now);

  void ask(ByteView bytes, Step step, TimePoint now);

  /// By the kind of their replies. All scans look alike: of several that were asked for, the first
  /// answer is to the oldest; those that are lost are found by the replies of the next set-up.
  Questions<std::uint8_t> questions_;
  bool waiting_ = false;  ///< for a scan
  std::uint64_t bad_seen_ = 0;
  TimePoint incomplete_since_;
  bool incomplete_ = false;
};

}  // namespace striate::pioneer
