#pragma once

#include <optional>
#include <string>
#include <vector>

#include "striate/base/time.hpp"
#include "striate/platform/pioneer/laser/scip.hpp"

namespace striate::pioneer {

/// A URG-04LX as a program sees it: the commands of SCIP 2.0 with their states, and ten scans a
/// second.
class UrgDevice {
 public:
  void receive(ByteView bytes);
  /// What its clock shows from now on.
  void set_time(TimePoint now) { now_ = now; }
  /// A scan has been asked for and is due.
  [[nodiscard]] bool measures(TimePoint now) const {
    return (running_ && now >= next_scan_) || (!asked_.empty() && now >= next_turn_);
  }
  /// Call in steps of at most 100 ms. ranges_mm: one for each step of the device's parameters.
  void step(TimePoint now, const std::vector<int>& ranges_mm);
  [[nodiscard]] Bytes take_output();
  [[nodiscard]] const scip::Parameters& parameters() const { return parameters_; }
  [[nodiscard]] std::size_t rays() const {
    return static_cast<std::size_t>(parameters_.last_step - parameters_.first_step + 1);
  }
  /// It sends scans by itself.
  [[nodiscard]] bool streams() const { return running_.has_value(); }
  /// Commands that it knew, whether it obeyed or refused them.
  [[nodiscard]] std::uint64_t understood() const { return understood_; }
  /// As after its plug was out.
  void reboot();

 private:
  /// What scans are wanted: the command, in parts.
  struct Scans {
    std::string head;  ///< the echo up to the count of an MD or MS
    std::string tail;  ///< what the client has put behind ';'
    scip::ScanRequest request;
  };
  void take_line();
  void obey(const std::string& body, const std::string& tail);
  void say(const std::string& echo, const std::string& status,
           const std::vector<std::string>& info = {});
  [[nodiscard]] std::string switch_state(const std::string& kind, const std::string& parameter);
  [[nodiscard]] std::string set_clock_mode(char mode);
  [[nodiscard]] std::string set_speed(const std::string& level);
  [[nodiscard]] std::string set_bit_rate(const std::string& rate);
  [[nodiscard]] std::string ask_reboot();
  [[nodiscard]] std::string ask_scans(const std::string& body, const std::string& tail);
  [[nodiscard]] std::vector<std::string> info_of(const std::string& kind) const;
  void laser_off();
  [[nodiscard]] Duration turn() const;
  [[nodiscard]] int shown_ms() const;
  [[nodiscard]] std::vector<int> grouped(const scip::ScanRequest& request,
                                         const std::vector<int>& ranges_mm) const;

  scip::Parameters parameters_;
  std::string line_;
  Bytes output_;
  std::uint64_t understood_ = 0;
  bool laser_on_ = false;
  bool clock_mode_ = false;  ///< TM0 was said
  bool sensitive_ = false;
  int slower_ = 0;  ///< level of CR, 0 .. 10
  int bit_rate_ = kBitRate;
  std::optional<Scans> running_;
  std::vector<Scans> asked_;  ///< one scan each: GD, GS
  std::optional<TimePoint> reboot_asked_;
  TimePoint now_;
  TimePoint zero_;  ///< where its clock showed 0
  TimePoint next_scan_;
  TimePoint next_turn_;  ///< of the mirror, after a scan that was asked for

  /// A level of CR is a hundredth of the speed: which, the specification leaves open (ours)
  static constexpr int kSlowerShare = 100;
  static constexpr int kBitRate = 19200;  ///< bit/s when it is switched on; URG-04LX
};

}  // namespace striate::pioneer
