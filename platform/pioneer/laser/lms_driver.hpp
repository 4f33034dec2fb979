#pragma once

#include "striate/platform/pioneer/laser/laser_driver.hpp"
#include "striate/platform/pioneer/laser/lms200.hpp"

namespace striate::pioneer {

enum class LmsStep { begin, variant, install, unit, start, scan, closed };

/// A SICK LMS-200: sets it up (180 degrees in whole degrees, millimetres, continuous), and begins
/// again when it falls silent.
class LmsDriver : public LaserDriver<LmsStep, lms200::TelegramStream> {
 public:
  explicit LmsDriver(const LaserSettings& settings) : LaserDriver(settings) {}

  void receive(ByteView bytes, TimePoint now);
  void tick(TimePoint now);
  /// The laser measures on request only, which nobody makes.
  void close();

 private:
  using Step = LmsStep;
  void take(const lms200::Telegram& telegram, TimePoint now);
  void take_scan(const lms200::Telegram& telegram, TimePoint now);

  TimePoint incomplete_since_;
  bool incomplete_ = false;
};

}  // namespace striate::pioneer
