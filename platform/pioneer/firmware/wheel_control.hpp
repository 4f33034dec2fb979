#pragma once

#include <optional>

namespace striate::pioneer {

/// The controller's set-points and ramps: speeds, ways and headings become forward and turning
/// speed within the accelerations that were set.
class WheelControl {
 public:
  struct Limits {
    double forward_mm_s = 750.0;              ///< TransVelMax in FLASH; ARCOS manual
    double turn_deg_s = 100.0;                ///< RotVelMax in FLASH; ARCOS manual
    double acceleration_mm_s2 = 300.0;        ///< TransAcc in FLASH; ARCOS manual
    double deceleration_mm_s2 = 300.0;        ///< TransDecel in FLASH; ARCOS manual
    double turn_acceleration_deg_s2 = 100.0;  ///< RotAcc in FLASH; ARCOS manual
    double turn_deceleration_deg_s2 = 100.0;  ///< RotDecel in FLASH; ARCOS manual
  };

  /// No limit is set higher: the motors do no more. Of a real P3-DX's CONFIGpac.
  static constexpr Limits kTop{1000.0, 360.0, 2000.0, 2000.0, 300.0, 300.0};

  void set_forward(double mm_s);
  void set_turn(double deg_s);
  void set_wheels(double left_mm_s, double right_mm_s, double half_axle_mm);
  void move(double mm);
  void head_for(double heading_deg);
  /// Counter-clockwise, from where it looks now.
  void turn_by(double deg, double heading_deg) { head_for(heading_deg + deg); }
  /// Counter-clockwise, from the last heading that was wanted.
  void turn_on(double deg, double heading_deg);
  void stop();
  /// Stops much faster than the limits allow, and obeys nothing until it stands.
  void emergency_stop();
  /// No motion and no wishes: motors off.
  void release();
  /// The watchdog's: stands, but keeps the set-points.
  void hold(bool on) { held_ = on; }

  void step(double dt_s, double heading_deg);

  [[nodiscard]] double forward_mm_s() const { return forward_mm_s_; }
  [[nodiscard]] double turn_deg_s() const { return turn_deg_s_; }
  [[nodiscard]] bool wants_to_stand() const;
  [[nodiscard]] Limits& limits() { return limits_; }

 private:
  [[nodiscard]] double wanted_forward(double dt_s);
  [[nodiscard]] double wanted_turn(double heading_deg);

  Limits limits_;
  double set_forward_mm_s_ = 0.0;
  double set_turn_deg_s_ = 0.0;
  std::optional<double> way_left_mm_;
  std::optional<double> heading_deg_;
  double forward_mm_s_ = 0.0;
  double turn_deg_s_ = 0.0;
  bool emergency_ = false;
  bool held_ = false;
};

}  // namespace striate::pioneer
