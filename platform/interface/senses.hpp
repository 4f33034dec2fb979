#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "striate/base/geometry.hpp"
#include "striate/base/time.hpp"

namespace striate {

/// Where the head looks, relative to the base: pan to the left, tilt up (looking down is negative).
struct HeadPose {
  double pan_rad = 0.0;
  double tilt_rad = 0.0;
};

/// One rectified image pair. Pixel centres at integers, u right, v down.
struct StereoFrame {
  TimePoint stamp;        ///< middle of the exposure
  cv::Mat3b left;         ///< BGR; empty until the first image has come
  cv::Mat3b right;        ///< same size as `left`; empty for one-eyed bodies
  double focal_px = 0.0;  ///< > 0
  double centre_u_px = 0.0;
  double centre_v_px = 0.0;
  double baseline_m = 0.0;  ///< > 0 where `right` is given
  HeadPose head;            ///< of the head at `stamp`, as far as the body knows it
};

/// Dead reckoning since the body started; drifts.
struct Odometry {
  TimePoint stamp;
  Pose2 pose;
  double forward_m_s = 0.0;
  double turn_rad_s = 0.0;
};

/// One echo of sonar or laser, seen from the middle of the wheel axle.
struct RangeReading {
  double bearing_rad = 0.0;
  double distance_m = 0.0;  ///< +inf: nothing within range
};

struct RangeScan {
  TimePoint stamp;
  std::vector<RangeReading> readings;
};

/// All that the body feels in one cycle. Each part has its own stamp: nothing stale drives.
struct Senses {
  TimePoint now;       ///< when this was handed out
  StereoFrame stereo;  ///< newest image pair that has arrived
  Odometry odometry;
  RangeScan sonar;  ///< for the safety limiter alone
  RangeScan laser;  ///< for the safety limiter alone
  HeadPose head;    ///< now
  double battery_v = 0.0;
  bool bumper = false;  ///< something is touched
  bool motors_stalled = false;
};

}  // namespace striate
