#pragma once

#include <array>
#include <optional>

#include "striate/config/settings.hpp"
#include "striate/platform/interface/robot.hpp"
#include "striate/platform/pioneer/questions.hpp"
#include "striate/platform/pioneer/turret/dynamixel.hpp"

namespace striate::pioneer {

struct TurretSettings {
  int pan_id = 1;   ///< as a PhantomX turret is delivered
  int tilt_id = 2;  ///< as a PhantomX turret is delivered
  /// A sixth of an AX-12A's 6.2 rad/s: a Bumblebee-2 is heavy for it
  double most_speed_rad_s = 1.0;
  double most_pan_rad =
      RobotDescription{}.max_pan_rad;  ///< 86 deg, of the servo's 150: cables (ours)
  double most_tilt_rad =
      RobotDescription{}.max_tilt_rad;  ///< 34 deg: the turret's frame is in the way beyond (ours)
  double patience_s = 0.03;             ///< two latencies of a USB adapter (16 ms for FTDI's)
  int silent_after = 5;                 ///< 0.15 s of patience
  double stuck_after_s = 1.0;           ///< 60 deg of turning at most_speed (ours)
};

template <class V>
void visit(V& v, TurretSettings& s) {
  using config::Unit;
  v.integer("pan_id", s.pan_id, {0, 252}, "of the servo that pans");
  v.integer("tilt_id", s.tilt_id, {0, 252}, "of the servo that tilts");
  v.number("most_speed", s.most_speed_rad_s, Unit::turn_rate, {0.02, 6.0},
           "of either servo; a heavy camera wants slow ones");
  v.number("most_pan", s.most_pan_rad, Unit::angle, {0.0, 2.6}, "to either side");
  v.number("most_tilt", s.most_tilt_rad, Unit::angle, {0.0, 1.5}, "up and down");
  v.number("patience", s.patience_s, Unit::duration, {0.005, 1.0},
           "for a servo's reply; then it is asked again");
  v.integer("silent_after", s.silent_after, {1, 100}, "missed replies in a row: it is silent");
  v.number("stuck_after", s.stuck_after_s, Unit::duration, {0.2, 10.0},
           "without coming nearer to its goal");
}

/// How one servo is.
struct ServoHealth {
  bool known = false;  ///< its position has been read
  double angle_rad = 0.0;
  TimePoint stamp;  ///< of the newest reply
  std::uint64_t missed = 0;
  int missed_in_a_row = 0;
  std::uint8_t errors = 0;  ///< dynamixel::Error of the newest reply
  double voltage_v = 0.0;
  int temperature_c = 0;
  double load = 0.0;  ///< -1 .. 1 of the most, counter-clockwise positive
  bool silent = false;
  bool stuck = false;
  bool tripped = false;  ///< latched: overload or overheat has switched it off
  [[nodiscard]] bool ok() const { return known && !silent && !stuck && !tripped; }
};

/// The pan/tilt head of two AX-12A on one half-duplex line: one question at a time. Positions are
/// read before anything moves, speeds are limited, and no servo that fails holds up the other. Each
/// question asks for another number of registers, so that a late reply is not taken for that to a
/// newer question.
/// Pure: bytes and times go in, bytes come out.
class TurretDriver {
 public:
  explicit TurretDriver(const TurretSettings& settings);

  /// Where it shall look; clamped. Until then it stays where it is.
  void command(const HeadPose& wanted);
  /// Gives a tripped servo its torque back; it stays where it is until the next command.
  void reset();

  /// The line is a new one: no reply is on its way.
  void line_up() { questions_.clear(); }
  void receive(ByteView bytes, TimePoint now);
  void tick(TimePoint now);
  [[nodiscard]] Bytes take_output();

  [[nodiscard]] HeadPose pose() const {
    return {servos_[0].health.angle_rad, servos_[1].health.angle_rad};
  }
  [[nodiscard]] const ServoHealth& pan() const { return servos_[0].health; }
  [[nodiscard]] const ServoHealth& tilt() const { return servos_[1].health; }
  [[nodiscard]] bool ok() const { return pan().ok() && tilt().ok(); }
  [[nodiscard]] const dynamixel::Counters& counters() const { return stream_.counters(); }

 private:
  struct Servo {
    std::uint8_t id = 0;
    double most_rad = 0.0;
    std::optional<double> goal_rad;
    double from_rad = 0.0;  ///< where it was at `moved_at`
    TimePoint moved_at;     ///< when it last was there, or had come nearer
    ServoHealth health;
  };
  void ask(TimePoint now);
  void write_goals();
  void take(Servo& servo, const dynamixel::Packet& packet, TimePoint now);
  static void begin_to_watch(Servo& servo, TimePoint now);
  void watch_progress(Servo& servo, TimePoint now);
  void miss(Servo& servo);

  TurretSettings settings_;
  std::array<Servo, 2> servos_;
  dynamixel::PacketStream stream_;
  Bytes output_;
  std::size_t turn_ = 0;  ///< whose turn to be asked
  /// By which replies are told apart.
  struct Asked {
    std::uint8_t id = 0;
    std::size_t size = 0;
    friend bool operator==(const Asked&, const Asked&) = default;
  };
  Questions<Asked> questions_;
  std::size_t size_ = 0;     ///< registers that the newest question asks for
  std::uint32_t mixed_ = 0;  ///< what that is drawn from
  bool waiting_ = false;     ///< for the reply of servos_[turn_]
  TimePoint asked_at_;
};

}  // namespace striate::pioneer
