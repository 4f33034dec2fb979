#pragma once

#include <string>

#include "striate/platform/pioneer/laser/laser_driver.hpp"
#include "striate/platform/pioneer/laser/scip.hpp"
#include "striate/platform/pioneer/line_clock.hpp"

namespace striate::pioneer {

enum class UrgStep {
  begin,
  protocol,
  quiet,
  clock_on,
  clock,
  clock_off,
  ask,
  laser_on,
  scan,
  closed
};

/// A Hokuyo range finder that speaks SCIP 2.0: sets it up, keeps it scanning, and begins again when
/// it falls silent, as after its plug was out, or late. Set-up asks what the device's clock shows,
/// so that the stamps of its scans tell how long they were under way; a device that does not say
/// is believed in the distances between them.
class UrgDriver : public LaserDriver<UrgStep, scip::ReplyStream> {
 public:
  explicit UrgDriver(const LaserSettings& settings) : LaserDriver(settings) {}

  /// The line is a new one.
  void line_up() { clock_.begin_anew(); }
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
  void take_clock(const scip::Reply& reply, TimePoint now);
  [[nodiscard]] Duration device_time(int shown_ms);
  [[nodiscard]] std::string clock_question() const;

  scip::Parameters parameters_;
  LineClock clock_;
  int shown_ms_ = 0;        ///< by the device, 24 bits
  Duration device_time_{};  ///< the same, unwrapped
};

}  // namespace striate::pioneer
