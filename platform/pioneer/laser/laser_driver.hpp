#pragma once

#include <cstdint>

#include "striate/platform/interface/senses.hpp"
#include "striate/platform/pioneer/laser/laser_conversation.hpp"

namespace striate::pioneer {

/// What the drivers of both kinds of laser offer alike. Pure: bytes and times go in, bytes come
/// out.
/// @tparam Step what has been said and waits for its reply, see LaserConversation
/// @tparam Stream cuts the laser's bytes into replies, and has `counters()`
template <class Step, class Stream>
class LaserDriver {
 public:
  [[nodiscard]] Bytes take_output() { return talk_.take_output(); }

  /// The newest scan seen from the axle; empty when it is stale. Its stamp is the first ray's.
  [[nodiscard]] RangeScan scan(TimePoint now) const { return talk_.scan(now); }
  [[nodiscard]] bool scanning(TimePoint now) const { return !scan(now).readings.empty(); }
  [[nodiscard]] const auto& counters() const { return stream_.counters(); }
  /// How often the set-up was begun.
  [[nodiscard]] std::uint64_t set_ups() const { return talk_.set_ups(); }

 protected:
  explicit LaserDriver(const LaserSettings& settings) : talk_(settings) {}
  ~LaserDriver() = default;

  LaserConversation<Step> talk_;
  Stream stream_;
};

}  // namespace striate::pioneer
