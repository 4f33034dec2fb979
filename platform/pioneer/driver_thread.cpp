#include "striate/platform/pioneer/driver_thread.hpp"

#include <cmath>
#include <exception>

namespace striate::pioneer {
namespace {

/// A packet of the base waits so long at most; one comes every 100 ms
constexpr Duration kDriverTick = std::chrono::milliseconds(5);
/// The slowest braking that may be set takes longer; then the motors go off while it rolls.
constexpr Duration kLongestBraking = std::chrono::milliseconds(2500);
/// A SIP cycle of 100 ms and the bytes of a stop at 9600 baud
constexpr Duration kStopHasArrived = std::chrono::milliseconds(150);
constexpr double kStands_m_s = 0.01;  // ten times the resolution of a SIP's wheel speeds, 1 mm/s
/// Ten times the resolution of a SIP's turning speed, 0.1 deg/s
constexpr double kStandsRad_s = 0.02;

}  // namespace

DriverThread::DriverThread(const BaseDriverSettings& settings, std::unique_ptr<Transport> line,
                           const Clock& clock)
    : clock_(clock),
      line_(std::move(line)),
      driver_(settings, *line_),
      thread_([this] { run(); }) {}

DriverThread::~DriverThread() {
  ends_ = true;
  thread_.join();
}

void DriverThread::command(const MotorCommand& command, std::optional<TimePoint> seen_at) {
  const TimePoint now = clock_.now();
  const std::lock_guard lock(mutex_);
  slot_.command = command;
  slot_.given_at = now;
  slot_.seen_at = seen_at;
}

void DriverThread::emergency_stop() {
  const std::lock_guard lock(mutex_);
  slot_.emergency = true;
  slot_.reset = false;
}

void DriverThread::reset() {
  const std::lock_guard lock(mutex_);
  slot_.reset = true;
}

void DriverThread::ask_true_pose() {
  const std::lock_guard lock(mutex_);
  slot_.ask_true_pose = true;
}

void DriverThread::set_head_ok(bool ok) {
  const TimePoint now = clock_.now();
  const std::lock_guard lock(mutex_);
  slot_.head_ok = ok;
  slot_.head_told_at = now;
}

void DriverThread::laser_has_measured(TimePoint stamp) {
  const std::lock_guard lock(mutex_);
  slot_.laser_at = stamp;
}

DriverReport DriverThread::report() const {
  const std::lock_guard lock(mutex_);
  return report_;
}

bool DriverThread::wait_until_it_can_drive(Duration at_most) {
  std::unique_lock lock(mutex_);
  const auto decided = [this] {
    const bool drives = report_.state == LinkState::ready && report_.base.motors_on;
    return drives || report_.state == LinkState::refused;
  };
  told_.wait_for(lock, at_most, decided);
  return decided() && report_.state == LinkState::ready;
}

void DriverThread::obey(const Slot& slot, TimePoint now) {
  SafetyGate& gate = driver_.gate();
  if (slot.reset) gate.reset(now);
  if (slot.command) gate.command(*slot.command, slot.given_at, slot.seen_at);
  if (slot.emergency) gate.emergency_stop(now);
  if (slot.ask_true_pose) driver_.session().ask_true_pose();
  if (slot.head_ok) gate.set_head_ok(*slot.head_ok, slot.head_told_at);
  if (slot.laser_at) gate.laser_has_measured(*slot.laser_at);
}

void DriverThread::tell(TimePoint now) {
  const ArcosSession& session = driver_.session();
  const std::lock_guard lock(mutex_);
  report_.state = session.state();
  report_.base = session.base();
  report_.hold = driver_.gate().reason();
  report_.latched = driver_.gate().latched();
  report_.line_delay = session.line_delay(now);
  report_.counters = session.counters();
  report_.robot = session.names().name + " (" + session.names().subclass + ")";
  const std::string line = line_->trouble();
  report_.trouble = session.trouble();
  if (!report_.trouble.empty() && !line.empty()) report_.trouble += ": " + line;
  report_.most_forward_m_s = session.most_forward_mm_s() / 1000.0;
  report_.most_turn_rad_s = radians(session.most_turn_deg_s());
  report_.true_pose = session.true_pose();
  told_.notify_all();
}

/// Motors that go off let the wheels roll on: first a stand, as far as the robot still obeys.
void DriverThread::brake_to_a_stand() {
  const TimePoint begin = clock_.now();
  for (TimePoint now = begin; now - begin < kLongestBraking; now = clock_.now()) {
    const ArcosSession& session = driver_.session();
    if (session.state() != LinkState::ready || !session.base().motors_on) return;
    driver_.gate().command({}, now);
    driver_.step(now);
    // What the robot says is as old as its packet, which may be from before the stop.
    const BaseState& base = session.base();
    const bool stands = std::abs(base.odometry.forward_m_s) < kStands_m_s &&
                        std::abs(base.odometry.turn_rad_s) < kStandsRad_s;
    if (stands && base.stamp - begin > kStopHasArrived) return;
    line_->wait(kDriverTick);
  }
}

void DriverThread::say_goodbye() {
  brake_to_a_stand();
  driver_.close();
  driver_.step(clock_.now());
  line_->close();
}

void DriverThread::run() {
  try {
    while (!ends_) {
      line_->wait(kDriverTick);
      Slot slot;
      {
        const std::lock_guard lock(mutex_);
        std::swap(slot, slot_);
      }
      const TimePoint now = clock_.now();
      obey(slot, now);
      driver_.step(now);
      tell(now);
    }
    say_goodbye();
  } catch (const std::exception& error) {
    give_up(error.what());
  } catch (...) {
    give_up("an unknown error");
  }
}

/// Nothing may leave the thread, for that would end the program before the robot is told.
void DriverThread::give_up(const char* why) noexcept {
  try {
    say_goodbye();
  } catch (...) {  // a line that is gone: its keeper or the robot's own watchdog stops it
  }
  const std::lock_guard lock(mutex_);
  report_.state = LinkState::closed;
  report_.hold = HoldReason::link_lost;
  try {
    report_.trouble = why;
  } catch (...) {  // no memory for the words, either
  }
  told_.notify_all();
}

}  // namespace striate::pioneer
