#pragma once

#include <functional>
#include <memory>
#include <string>

#include "striate/platform/interface/senses.hpp"
#include "striate/platform/pioneer/device_thread.hpp"
#include "striate/platform/pioneer/laser/laser_settings.hpp"

namespace striate::pioneer {

/// A laser on a line of its own, in a thread of its own; scans come out through one slot.
class LaserLink {
 public:
  /// Told the stamp of each scan; called in the link's thread.
  using Watcher = std::function<void(TimePoint stamp)>;

  /// `clock` must outlive this.
  LaserLink(const LaserSettings& settings, std::unique_ptr<Transport> line, const Clock& clock,
            Watcher watcher);
  ~LaserLink();

  /// The newest scan seen from the axle; empty when it is stale.
  [[nodiscard]] RangeScan scan() const { return scan_.newest(); }
  [[nodiscard]] std::string trouble() const { return thread_->trouble(); }

 private:
  template <class Driver>
  struct LaserDevice;

  Mailbox<RangeScan> scan_;
  std::unique_ptr<Device> device_;
  std::unique_ptr<DeviceThread> thread_;  // last: it uses the device
};

}  // namespace striate::pioneer
