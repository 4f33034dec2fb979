#pragma once

#include "platform/interface/senses.hpp"
#include "platform/pioneer/laser/laser_conversation.hpp"
#include "platform/pioneer/laser/lms200.hpp"

namespace striate::pioneer {

/// A SICK LMS-200: sets it up (180 degrees in whole degrees, millimetres, continuous), and begins
/// again when it falls silent. Pure: bytes and times go in, bytes come out.
class LmsDriver {
 public:
  explicit LmsDriver(const LaserSettings& settings) : talk_(settings) {}

  void receive(ByteView bytes, TimePoint now);
  void tick(TimePoint now);
  [[nodiscard]] Bytes take_output() { return talk_.take_output(); }
  /// The laser measures on request only, which nobody makes.
  void close();

  /// The newest scan seen from the axle; empty when it is stale. Its stamp is the first ray's.
  [[nodiscard]] RangeScan scan(TimePoint now) const { return talk_.scan(now); }
  [[nodiscard]] bool scanning(TimePoint now) const { return !scan(now).readings.empty(); }
  [[nodiscard]] const lms200::Counters& counters() const { return stream_.counters(); }
  [[nodiscard]] std::uint64_t set_ups() const { return talk_.set_ups(); }

 private:
  /// What has been said and waits for its reply.
  enum class Step { begin, variant, install, unit, start, scan, closed };
  void take(const lms200::Telegram& telegram, TimePoint now);
  void take_scan(const lms200::Telegram& telegram, TimePoint now);

  LaserConversation<Step> talk_;
  lms200::TelegramStream stream_;
  TimePoint incomplete_since_;
  bool incomplete_ = false;
};

}  // namespace striate::pioneer
