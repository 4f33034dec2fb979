#pragma once

#include "striate/config/settings.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::pioneer {

struct SessionSettings {
  bool force_unknown_model = false;
  bool joystick_may_drive = true;
  bool simulated_laser = true;
  bool echo = true;
  double sync_wait_s = 1.0;   ///< as ARIA waits for the answer to a SYNC
  int sync_tries = 5;         ///< as ARIA gives up after five that stay silent
  double lost_after_s = 2.0;  ///< twenty SIPs missed; the watchdog has stopped the wheels by then
  double back_off_s = 0.5;    ///< five SIP cycles; doubles each time
  /// Four doublings: so soon a robot that is switched on is found
  double longest_back_off_s = 8.0;
  double most_forward_m_s =
      RobotDescription{}.max_forward_m_s;  ///< TransVelMax in a P3-DX's FLASH, 750 mm/s
  double most_turn_rad_s =
      RobotDescription{}
          .max_turn_rad_s;  ///< 69 deg/s, below RotVelMax in a P3-DX's FLASH, 100 deg/s (ours)
  double acceleration_m_s2 =
      RobotDescription{}
          .max_acceleration_m_s2;  ///< stops from 0.75 m/s within 0.56 m; FLASH has 0.3 (ours)
  double turn_acceleration_rad_s2 =
      RobotDescription{}
          .max_turn_acceleration_rad_s2;  ///< 115 deg/s2, about RotAcc in a P3-DX's FLASH (100)
};

template <class V>
void visit(V& v, SessionSettings& s) {
  using config::Unit;
  v.flag("force_unknown_model", s.force_unknown_model,
         "drive a robot of an unknown kind with the factors of p3dx-sh");
  v.flag("joystick_may_drive", s.joystick_may_drive, "the joystick's button takes over");
  v.flag("simulated_laser", s.simulated_laser,
         "asks a simulated robot for the laser inside its packets");
  v.flag("echo", s.echo,
         "measures how late the line is by questions; no: for a robot that answers none, whose "
         "delay nobody knows then");
  v.number("sync_wait", s.sync_wait_s, Unit::duration, {0.1, 10.0},
           "for the answer to one step of the handshake");
  v.integer("sync_tries", s.sync_tries, {1, 50}, "silent steps until the link is opened anew");
  v.number("lost_after", s.lost_after_s, Unit::duration, {0.5, 60.0},
           "without a packet the robot is lost and the link is opened anew");
  v.number("back_off", s.back_off_s, Unit::duration, {0.05, 60.0},
           "before the link is opened anew; doubles each time");
  v.number("longest_back_off", s.longest_back_off_s, Unit::duration, {0.05, 600.0},
           "it never waits longer");
  v.number("most_forward", s.most_forward_m_s, Unit::speed, {0.05, 2.2}, "told to the robot");
  v.number("most_turn", s.most_turn_rad_s, Unit::turn_rate, {0.05, 8.0}, "told to the robot");
  v.number("acceleration", s.acceleration_m_s2, Unit::acceleration, {0.05, 2.0},
           "of speeding up and of slowing down; told to the robot");
  v.number("turn_acceleration", s.turn_acceleration_rad_s2, Unit::turn_acceleration, {0.1, 5.0},
           "told to the robot");
}

}  // namespace striate::pioneer
