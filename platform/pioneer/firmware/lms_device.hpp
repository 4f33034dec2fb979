#pragma once

#include <vector>

#include "striate/base/time.hpp"
#include "striate/platform/pioneer/laser/lms200.hpp"

namespace striate::pioneer {

/// An LMS-200 as a program sees it: acknowledges, replies, and scans: one on request, or ten
/// a second by itself.
class LmsDevice {
 public:
  void receive(ByteView bytes);
  /// Call in steps of at most 100 ms. ranges_m: 181 from right to left.
  void step(TimePoint now, const std::vector<double>& ranges_m);
  [[nodiscard]] Bytes take_output();
  /// As after its plug was out.
  void reboot() { *this = LmsDevice(); }

 private:
  void obey(const lms200::Telegram& telegram);
  void reply(Bytes data);

  lms200::TelegramStream stream_{lms200::kToLaser};
  Bytes output_;
  bool installing_ = false;
  bool scanning_ = false;  ///< by itself
  bool asked_ = false;     ///< for one scan
  TimePoint next_scan_;
};

}  // namespace striate::pioneer
