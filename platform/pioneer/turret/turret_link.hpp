#pragma once

#include <functional>
#include <optional>
#include <string>

#include "striate/platform/pioneer/device_thread.hpp"
#include "striate/platform/pioneer/turret/head_history.hpp"
#include "striate/platform/pioneer/turret/turret_driver.hpp"

namespace striate::pioneer {

/// What is known of the head from outside its thread.
struct HeadReport {
  HeadHistory trajectory;
  HeadPose pose;  ///< newest
  ServoHealth pan;
  ServoHealth tilt;
  [[nodiscard]] bool known() const { return pan.known && tilt.known; }
  [[nodiscard]] bool ok() const { return pan.ok() && tilt.ok(); }
};

/// The turret on its line, in a thread of its own: a wanted pose goes in through one slot, reports
/// come out through another.
class TurretLink {
 public:
  /// Told at each step whether the head obeys; called in the link's thread.
  using Watcher = std::function<void(bool ok)>;

  /// `clock` must outlive this.
  TurretLink(const TurretSettings& settings, std::unique_ptr<Transport> line, const Clock& clock,
             Watcher watcher);

  void command(const HeadPose& wanted) { device_.wanted.put(wanted); }
  /// Gives a tripped servo its torque back.
  void reset() { device_.reset = true; }
  [[nodiscard]] HeadReport report() const { return device_.report.newest(); }
  [[nodiscard]] std::string trouble() const { return thread_.trouble(); }

 private:
  struct HeadDevice final : public Device {
    HeadDevice(const TurretSettings& settings, Watcher watcher_in)
        : driver(settings), watcher(std::move(watcher_in)) {}
    void line_up(TimePoint /*now*/) override { driver.line_up(); }
    void receive(ByteView bytes, TimePoint now) override { driver.receive(bytes, now); }
    void tick(TimePoint now) override;
    [[nodiscard]] Bytes take_output() override { return driver.take_output(); }

    TurretDriver driver;
    Watcher watcher;
    HeadReport known;
    Mailbox<std::optional<HeadPose>> wanted;
    Mailbox<HeadReport> report;
    std::atomic<bool> reset{false};
  };
  HeadDevice device_;
  DeviceThread thread_;  // last: it uses the device
};

}  // namespace striate::pioneer
