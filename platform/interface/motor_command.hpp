#pragma once

namespace striate {

/// What the body is told to do until the next command. The default is stop, looking straight ahead.
struct MotorCommand {
  double forward_m_s = 0.0;
  double turn_rad_s = 0.0;  ///< counter-clockwise
  double pan_rad = 0.0;     ///< wanted head pose, left positive
  double tilt_rad = 0.0;    ///< up positive
};

}  // namespace striate
