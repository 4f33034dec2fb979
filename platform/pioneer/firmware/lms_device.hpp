#pragma once

#include <vector>

#include "striate/base/time.hpp"
#include "striate/platform/pioneer/laser/lms200.hpp"

namespace striate::pioneer {

/// An LMS-200 as a program sees it: acknowledges, replies, tells its type, status and
/// configuration, and scans: one on request, or ten a second by itself.
class LmsDevice {
 public:
  void receive(ByteView bytes);
  /// Call in steps of at most 100 ms. ranges_m: one for each of bearings_rad().
  void step(TimePoint now, const std::vector<double>& ranges_m);
  /// A scan is due.
  [[nodiscard]] bool measures(TimePoint now) const {
    return asked_ || (scanning_ && now >= next_scan_);
  }
  /// Where its rays look, from right to left, as field and resolution were set.
  [[nodiscard]] std::vector<double> bearings_rad() const;
  [[nodiscard]] Bytes take_output();
  /// It sends scans by itself.
  [[nodiscard]] bool streams() const { return scanning_; }
  /// Telegrams that have come so far.
  [[nodiscard]] std::uint64_t understood() const { return stream_.counters().telegrams; }
  /// As after its plug was out.
  void reboot();

 private:
  void obey_all();
  void obey(const lms200::Telegram& telegram);
  void reply(Bytes data);
  void set_mode(const Bytes& data);
  void set_variant(const Bytes& data);
  void configure(const Bytes& data);
  void tell_status();

  lms200::TelegramStream stream_{lms200::kToLaser};
  Bytes output_;
  Bytes configuration_ = factory_configuration();
  int field_deg_ = 180;
  int increment_cdeg_ = 100;
  std::uint8_t mode_ = kOnRequest;
  std::uint8_t baud_ = 0x42;  ///< code of 20: 9600
  bool installing_ = false;
  bool scanning_ = false;  ///< by itself
  bool asked_ = false;     ///< for one scan
  bool starting_ = false;  ///< its name is still to be told
  TimePoint next_scan_;
  TimePoint now_;
  TimePoint heard_;

  static constexpr std::uint8_t kOnRequest = 0x25;  ///< operating mode; SICK LMS-200 telegrams, 20
  static Bytes factory_configuration();
};

}  // namespace striate::pioneer
