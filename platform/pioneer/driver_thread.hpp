#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "striate/platform/pioneer/base_driver.hpp"

namespace striate::pioneer {

/// What is known from outside the thread.
struct DriverReport {
  LinkState state = LinkState::waiting;
  BaseState base;
  HoldReason hold = HoldReason::not_ready;
  bool latched = false;
  std::optional<Duration> line_delay;  ///< there and back; nothing: not known
  LinkCounters counters;
  std::string robot;    ///< "name (subclass)"
  std::string trouble;  ///< in plain words; empty: none
  double most_forward_m_s = 0.0;
  double most_turn_rad_s = 0.0;
  std::optional<arcos::SimStat> true_pose;  ///< simulated robots only, once asked for
};

/// Gives a BaseDriver its own thread, so that its deadlines hold whatever the caller does. Commands
/// go in through one slot, reports come out through one slot; neither side waits for the other.
class DriverThread {
 public:
  /// `clock` must outlive this.
  DriverThread(const BaseDriverSettings& settings, std::unique_ptr<Transport> line,
               const Clock& clock);
  /// Brakes to a stand, motors off, CLOSE.
  ~DriverThread();
  DriverThread(const DriverThread&) = delete;
  DriverThread& operator=(const DriverThread&) = delete;

  /// Holds until its lease ends.
  /// @param seen_at when the image was taken that it was decided by; nothing: by none
  void command(const MotorCommand& command, std::optional<TimePoint> seen_at = std::nullopt);
  void emergency_stop();
  /// Ends what is latched.
  void reset();
  void ask_true_pose();
  /// What other devices say of themselves, for the safety gate; see there.
  void set_head_ok(bool ok);
  void laser_has_measured(TimePoint stamp);

  [[nodiscard]] DriverReport report() const;
  /// True as soon as the robot's motors are on; false after `at_most`, or when the robot is
  /// refused.
  [[nodiscard]] bool wait_until_it_can_drive(Duration at_most);

 private:
  struct Slot {
    std::optional<MotorCommand> command;
    TimePoint given_at;
    std::optional<TimePoint> seen_at;
    bool emergency = false;
    bool reset = false;
    bool ask_true_pose = false;
    std::optional<bool> head_ok;
    TimePoint head_told_at;
    std::optional<TimePoint> laser_at;
  };
  void run();
  void obey(const Slot& slot, TimePoint now);
  void tell(TimePoint now);
  void brake_to_a_stand();
  void say_goodbye();
  void give_up(const char* why) noexcept;

  const Clock& clock_;
  std::unique_ptr<Transport> line_;
  BaseDriver driver_;

  mutable std::mutex mutex_;
  std::condition_variable told_;
  Slot slot_;
  DriverReport report_;
  std::atomic<bool> ends_{false};
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace striate::pioneer
