#pragma once

#include <optional>
#include <string>

#include "platform/interface/senses.hpp"
#include "platform/pioneer/laser/laser_conversation.hpp"
#include "platform/pioneer/laser/scip.hpp"

namespace striate::pioneer {

/// A Hokuyo range finder that speaks SCIP 2.0: sets it up, keeps it scanning, and begins again when
/// it falls silent, as after its plug was out. Pure: bytes and times go in, bytes come out.
class UrgDriver {
 public:
  explicit UrgDriver(const LaserSettings& settings) : talk_(settings) {}

  void receive(ByteView bytes, TimePoint now);
  void tick(TimePoint now);
  [[nodiscard]] Bytes take_output() { return talk_.take_output(); }
  /// Laser off.
  void close();

  /// The newest scan seen from the axle; empty when it is stale. Its stamp is the first ray's.
  [[nodiscard]] RangeScan scan(TimePoint now) const { return talk_.scan(now); }
  [[nodiscard]] bool scanning(TimePoint now) const { return !scan(now).readings.empty(); }
  [[nodiscard]] const scip::Parameters& parameters() const { return parameters_; }
  [[nodiscard]] const scip::Counters& counters() const { return stream_.counters(); }
  [[nodiscard]] std::uint64_t set_ups() const { return talk_.set_ups(); }

 private:
  /// What has been said and waits for its reply.
  enum class Step { begin, protocol, quiet, ask, laser_on, scan, closed };
  void say(const std::string& line, Step step, TimePoint now);
  void take(const scip::Reply& reply, TimePoint now);
  void take_scan(const scip::Reply& reply, TimePoint now);

  LaserConversation<Step> talk_;
  scip::ReplyStream stream_;
  scip::Parameters parameters_;
};

}  // namespace striate::pioneer
