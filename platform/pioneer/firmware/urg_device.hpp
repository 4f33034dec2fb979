#pragma once

#include <optional>
#include <string>
#include <vector>

#include "striate/base/time.hpp"
#include "striate/platform/pioneer/laser/scip.hpp"

namespace striate::pioneer {

/// A URG-04LX as a program sees it: SCIP 2.0 replies and ten scans a second.
class UrgDevice {
 public:
  void receive(ByteView bytes);
  /// What its clock shows from now on.
  void set_time(TimePoint now) { now_ = now; }
  /// A scan has been asked for and is due.
  [[nodiscard]] bool measures(TimePoint now) const { return running_ && now >= next_scan_; }
  /// Call in steps of at most 100 ms. ranges_mm: one for each step of the device's parameters.
  void step(TimePoint now, const std::vector<int>& ranges_mm);
  [[nodiscard]] Bytes take_output();
  [[nodiscard]] const scip::Parameters& parameters() const { return parameters_; }
  [[nodiscard]] std::size_t rays() const {
    return static_cast<std::size_t>(parameters_.last_step - parameters_.first_step + 1);
  }
  /// As after its plug was out.
  void reboot();

 private:
  void obey(const std::string& line);
  void say(const scip::Reply& reply, bool info = false);
  void start_scanning(const std::string& line);
  [[nodiscard]] int shown_ms() const;

  scip::Parameters parameters_;
  std::string line_;
  Bytes output_;
  bool laser_on_ = false;
  std::optional<scip::ScanRequest> running_;
  TimePoint now_;
  TimePoint next_scan_;
};

}  // namespace striate::pioneer
