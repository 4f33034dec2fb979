#pragma once

#include <functional>
#include <variant>

#include "striate/platform/pioneer/firmware/lms_device.hpp"
#include "striate/platform/pioneer/firmware/urg_device.hpp"
#include "striate/platform/pioneer/laser/laser_settings.hpp"

namespace striate::served {

/// The laser on a line of its own, of either kind.
class ServedLaser {
 public:
  /// How far it is to the next thing, counter-clockwise from ahead; +inf: nothing in range.
  using Range = std::function<double(double bearing_rad)>;

  explicit ServedLaser(pioneer::LaserKind kind);

  void receive(ByteView bytes);
  [[nodiscard]] Bytes take_output();
  /// As after its plug was out.
  void reboot();
  /// Scans when one is due.
  void step(TimePoint now, const Range& range);
  /// Commands that it knew.
  [[nodiscard]] std::uint64_t understood() const;
  /// It sends scans by itself.
  [[nodiscard]] bool streams() const;

 private:
  void turn(pioneer::UrgDevice& urg, TimePoint now, const Range& range) const;
  void turn(pioneer::LmsDevice& lms, TimePoint now, const Range& range) const;

  std::variant<pioneer::UrgDevice, pioneer::LmsDevice> device_;
};

}  // namespace striate::served
