#include "striate/platform/pioneer/laser/laser_link.hpp"

#include "striate/platform/pioneer/laser/lms_driver.hpp"
#include "striate/platform/pioneer/laser/urg_driver.hpp"

namespace striate::pioneer {

template <class Driver>
struct LaserLink::LaserDevice final : public Device {
  LaserDevice(const LaserSettings& settings, Mailbox<RangeScan>& slot_in, Watcher watcher_in)
      : driver(settings), slot(slot_in), watcher(std::move(watcher_in)) {}

  void line_up(TimePoint /*now*/) override { driver.line_up(); }
  void receive(ByteView bytes, TimePoint now) override { driver.receive(bytes, now); }
  void tick(TimePoint now) override {
    driver.tick(now);
    RangeScan scan = driver.scan(now);
    if (scan.stamp == told) return;
    told = scan.stamp;
    if (watcher && !scan.readings.empty()) watcher(scan.stamp);
    slot.put(std::move(scan));
  }
  [[nodiscard]] Bytes take_output() override { return driver.take_output(); }
  void close() override { driver.close(); }

  Driver driver;
  Mailbox<RangeScan>& slot;
  Watcher watcher;
  TimePoint told;
};

LaserLink::LaserLink(const LaserSettings& settings, std::unique_ptr<Transport> line,
                     const Clock& clock, Watcher watcher) {
  if (settings.kind == LaserKind::lms200) {
    device_ = std::make_unique<LaserDevice<LmsDriver>>(settings, scan_, std::move(watcher));
  } else {
    device_ = std::make_unique<LaserDevice<UrgDriver>>(settings, scan_, std::move(watcher));
  }
  thread_ = std::make_unique<DeviceThread>(*device_, std::move(line), clock);
}

LaserLink::~LaserLink() = default;

}  // namespace striate::pioneer
