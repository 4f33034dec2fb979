#pragma once

#include <string>

#include "striate/platform/pioneer/laser/laser_driver.hpp"
#include "striate/platform/pioneer/laser/scip.hpp"

namespace striate::pioneer {

enum class UrgStep { begin, protocol, quiet, ask, laser_on, scan, closed };

/// A Hokuyo range finder that speaks SCIP 2.0: sets it up, keeps it scanning, and begins again when
/// it falls silent, as after its plug was out.
class UrgDriver : public LaserDriver<UrgStep, scip::ReplyStream> {
 public:
  explicit UrgDriver(const LaserSettings& settings) : LaserDriver(settings) {}

  void receive(ByteView bytes, TimePoint now);
  void tick(TimePoint now);
  /// Laser off.
  void close();
  [[nodiscard]] const scip::Parameters& parameters() const { return parameters_; }

 private:
  using Step = UrgStep;
  void say(const std::string& line, Step step, TimePoint now);
  void take(const scip::Reply& reply, TimePoint now);
  void take_scan(const scip::Reply& reply, TimePoint now);

  scip::Parameters parameters_;
};

}  // namespace striate::pioneer
