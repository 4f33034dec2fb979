#include "striate/platform/pioneer/keeper/line_keeper.hpp"

#include <algorithm>
#include <cstdlib>

#include "striate/platform/pioneer/arcos/command.hpp"

namespace striate::pioneer {

using arcos::Command;
using arcos::command;

namespace {

/// A stop may be lost on the line; ARCOS has no answers to ask for. One SIP cycle
constexpr Duration kStopAgain = std::chrono::milliseconds(100);
/// A SIP cycle of 100 ms and the bytes of a stop at 9600 baud: what a robot said before is old
constexpr Duration kStopFelt = std::chrono::milliseconds(150);
/// By hand: a person who has stopped a program, or closed a notebook, is back by then; the robot
/// stands and holds until it is reset. After that it is let go, with its motors off
constexpr Duration kMindPatience = std::chrono::minutes(10);
/// The slowest braking that may be set, 0.05 m/s2, takes longer; or the robot cannot be heard
constexpr Duration kLongestStop = std::chrono::milliseconds(10000);
/// ARIA's pause between ENABLE 0 and CLOSE
constexpr Duration kBeforeClose = std::chrono::milliseconds(100);
/// 2048 bytes would take longer at 9600 baud, but a stop and a CLOSE take 60 ms
constexpr Duration kLongestDrain = std::chrono::milliseconds(300);
constexpr int kStandsStill_mm_s = 10;  // ten times the resolution of a SIP's wheel speeds
constexpr std::size_t kLongestBytes = 258;

/// Where things are in a packet: ARCOS manual, packet protocol and standard SIP
constexpr std::size_t kIdAt = 3;
constexpr std::size_t kArgumentAt = 4;
constexpr std::size_t kLeftAt = kIdAt + 7;
constexpr std::size_t kRightAt = kIdAt + 9;

int speed_at(ByteView packet, std::size_t at) {
  return static_cast<std::int16_t>(packet[at] | packet[at + 1] << 8);
}

/// P2OS and ARCOS have had these ids for the packet that tells of the wheels.
bool tells_of_wheels(ByteView packet) {
  return packet[kIdAt] >= 0x30 && packet[kIdAt] <= 0x34 && packet.size() > kRightAt + 3;
}

}  // namespace

LineKeeper::LineKeeper()
    : stop_(command(Command::velocity, 0)),
      motors_off_(command(Command::enable, 0)),
      close_(command(Command::close, 1)) {
  // As the gate's own stop: the wheels brake as they were told to. An E_STOP would be harder than
  // what the robot's load and the floor were reckoned with.
  append(stop_, command(Command::rotation_velocity, 0));
}

void LineKeeper::enter(State state, TimePoint now) {
  state_ = state;
  since_ = now;
}

std::size_t LineKeeper::room_for_mind() const {
  const std::size_t free = queue_.size() - size_;
  // Beside what has just come, a packet may be whole that was held, and a stop must have its place.
  const std::size_t kept = 2 * kLongestBytes;
  return free > kept ? free - kept : 0;
}

void LineKeeper::put(ByteView bytes) {
  if (size_ + bytes.size() > queue_.size()) return;
  std::copy(bytes.begin(), bytes.end(), queue_.begin() + static_cast<std::ptrdiff_t>(size_));
  size_ += bytes.size();
}

std::size_t LineKeeper::front_bytes() const {
  const bool packet = size_ >= 3 && queue_[0] == 0xfa && queue_[1] == 0xfb;
  return packet ? std::min<std::size_t>(queue_[2] + std::size_t{3}, size_)
                : std::min(size_, std::size_t{1});
}

ByteView LineKeeper::to_robot() const {
  return ByteView(queue_.data(), size_).subspan(begun_);
}

void LineKeeper::sent(std::size_t count) {
  begun_ += count;
  while (size_ > 0 && begun_ >= front_bytes()) {
    const std::size_t whole = front_bytes();
    std::copy(queue_.begin() + static_cast<std::ptrdiff_t>(whole),
              queue_.begin() + static_cast<std::ptrdiff_t>(size_), queue_.begin());
    size_ -= whole;
    begun_ -= whole;
  }
}

/// Half a packet must be ended, or the robot takes the stop for its other half.
void LineKeeper::drop_what_has_not_begun() {
  size_ = begun_ > 0 ? front_bytes() : 0;
}

void LineKeeper::note_word(ByteView packet) {
  const bool has_argument = packet.size() > kArgumentAt + 2 + 2;
  const int value = has_argument ? packet[kArgumentAt + 1] | packet[kArgumentAt + 2] << 8 : 0;
  switch (static_cast<Command>(packet[kIdAt])) {
    case Command::open:  // without an argument it is SYNC1
      open_ = open_ || has_argument;
      break;
    case Command::close:  // without an argument it is SYNC2
      if (!has_argument) break;
      open_ = forward_ = turn_ = false;
      break;
    case Command::velocity:
    case Command::move:
      forward_ = value != 0;
      break;
    case Command::wheels:
      forward_ = value != 0;
      turn_ = false;
      break;
    case Command::rotation_velocity:
    case Command::rotate:
    case Command::turn:
      turn_ = value != 0;
      break;
    case Command::heading:
    case Command::turn_on:
      turn_ = true;
      break;
    case Command::stop:
    case Command::emergency_stop:
    case Command::quick_stop:
      forward_ = turn_ = false;
      break;
    default:
      break;
  }
}

void LineKeeper::from_mind(ByteView bytes, TimePoint now) {
  if (state_ > State::brakes) return;
  mind_.push(bytes, [&](ByteView part, bool packet) {
    put(part);
    if (!packet) return;  // half a word is no sign of life
    last_word_ = now;
    note_word(part);
    if (state_ == State::brakes) enter(State::relays, now);
  });
}

void LineKeeper::from_robot(ByteView bytes, TimePoint now) {
  robot_.push(bytes, [&](ByteView part, bool packet) {
    if (!packet || !tells_of_wheels(part) || in_state(now) < kStopFelt) return;
    stands_ = std::abs(speed_at(part, kLeftAt)) < kStandsStill_mm_s &&
              std::abs(speed_at(part, kRightAt)) < kStandsStill_mm_s;
  });
}

void LineKeeper::take_over(State state, TimePoint now) {
  drop_what_has_not_begun();
  forward_ = turn_ = stands_ = false;
  put(stop_);
  stop_sent_at_ = now;
  enter(state, now);
}

void LineKeeper::mind_has_died(TimePoint now) {
  if (state_ > State::brakes) return;
  if (open_) {
    take_over(State::brakes_for_good, now);
  } else {
    mind_lets_go(now);
  }
}

void LineKeeper::mind_lets_go(TimePoint now) {
  enter(State::drains, now);
}

void LineKeeper::tick(TimePoint now) {
  const bool stops = state_ == State::brakes || state_ == State::brakes_for_good;
  if (stops && size_ == 0 && now - stop_sent_at_ >= kStopAgain) {
    put(stop_);
    stop_sent_at_ = now;
  }
  switch (state_) {
    case State::relays:
      if ((forward_ || turn_) && now - last_word_ > kMindLease) take_over(State::brakes, now);
      break;
    case State::brakes:
      if (now - last_word_ > kMindPatience) enter(State::brakes_for_good, now);
      break;
    case State::brakes_for_good:
      if (!stands_ && in_state(now) < kLongestStop) break;
      put(motors_off_);
      enter(State::switches_off, now);
      break;
    case State::switches_off:
      if (in_state(now) < kBeforeClose) break;
      put(close_);
      enter(State::drains, now);
      break;
    case State::drains:
      if (size_ == 0 || in_state(now) > kLongestDrain) enter(State::done, now);
      break;
    case State::done:
      break;
  }
}

}  // namespace striate::pioneer
