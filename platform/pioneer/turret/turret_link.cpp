#include "striate/platform/pioneer/turret/turret_link.hpp"

namespace striate::pioneer {

TurretLink::TurretLink(const TurretSettings& settings, std::unique_ptr<Transport> line,
                       const Clock& clock, Watcher watcher)
    : device_(settings, std::move(watcher)), thread_(device_, std::move(line), clock) {}

void TurretLink::HeadDevice::tick(TimePoint now) {
  if (reset.exchange(false)) {
    driver.reset();
    wanted.put({});
  }
  if (const auto pose = wanted.newest()) driver.command(*pose);
  driver.tick(now);
  known.pan = driver.pan();
  known.tilt = driver.tilt();
  known.pose = driver.pose();
  if (known.known()) known.trajectory.add(std::min(known.pan.stamp, known.tilt.stamp), known.pose);
  report.put(known);
  if (watcher) watcher(driver.ok());
}

}  // namespace striate::pioneer
