#pragma once

#include <array>
#include <cstdint>

#include "striate/platform/pioneer/keeper/packet_cutter.hpp"

namespace striate::pioneer {

/// A mind whose robot moves must say something within it, or the robot is told to stand. The gate
/// repeats its speeds every 100 ms (SafetyGateSettings::send_every_s), so two in a row may be late;
/// by hand, for a stop within 0.3 s.
inline constexpr Duration kMindLease = std::chrono::milliseconds(250);

/// Stands between the mind and the robot's line, in a process of its own (kept_line.hpp), and stops
/// the robot when the mind dies or hangs. Passes whole packets on as they are, both ways. Pure:
/// bytes and times go in, bytes come out; allocates nothing after it is made.
class LineKeeper {
 public:
  LineKeeper();

  /// Takes no more than room_for_mind() bytes at once.
  void from_mind(ByteView bytes, TimePoint now);
  void from_robot(ByteView bytes, TimePoint now);
  /// It has died: the robot is braked until it says that it stands, then the session is closed.
  void mind_has_died(TimePoint now);
  /// It has closed the line on purpose: what it said last is sent, no more.
  void mind_lets_go(TimePoint now);
  /// Call every few 10 ms.
  void tick(TimePoint now);

  [[nodiscard]] std::size_t room_for_mind() const;
  /// Bytes for the robot, as much as its line takes; then tell how many it took.
  [[nodiscard]] ByteView to_robot() const;
  void sent(std::size_t count);

  /// The mind was silent for too long and is heard no more: its end should be closed.
  [[nodiscard]] bool mind_is_shut_out() const { return state_ >= State::brakes_for_good; }
  [[nodiscard]] bool done() const { return state_ == State::done; }

 private:
  enum class State {
    relays,
    brakes,           ///< the mind's lease is over; its next word ends that
    brakes_for_good,  ///< until the robot stands
    switches_off,     ///< motors off is sent
    drains,           ///< what is left goes out
    done,
  };
  void enter(State state, TimePoint now);
  void take_over(State state, TimePoint now);
  void put(ByteView bytes);
  void drop_what_has_not_begun();
  void note_word(ByteView packet);
  [[nodiscard]] std::size_t front_bytes() const;
  [[nodiscard]] Duration in_state(TimePoint now) const { return now - since_; }

  Bytes stop_;  ///< the keeper's own words, made before nothing may be allocated any more
  Bytes motors_off_;
  Bytes close_;

  State state_ = State::relays;
  TimePoint since_;  ///< of the state
  PacketCutter mind_;
  PacketCutter robot_;
  TimePoint last_word_;   ///< of the mind
  bool open_ = false;     ///< the session
  bool forward_ = false;  ///< what the mind wants is no stand
  bool turn_ = false;
  TimePoint stop_sent_at_;
  bool stands_ = false;  ///< says the robot, after a stop has reached it

  std::array<std::uint8_t, 2048> queue_{};  ///< begins with the packet that is on its way
  std::size_t size_ = 0;
  std::size_t begun_ = 0;  ///< bytes of the first packet that are sent
};

}  // namespace striate::pioneer
