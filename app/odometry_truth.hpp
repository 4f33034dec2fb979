#pragma once

#include <string>

#include "striate/evaluation/odometry/camera_truth.hpp"
#include "striate/platform/datasets/trajectories/trajectory.hpp"

namespace striate::app {

/// Says on standard error what was read, and what was left out or assumed.
void tell_trajectory(const char* which, const std::string& file,
                     const datasets::Trajectory& trajectory);

/// What an estimate is judged by.
struct OdometryTruth {
  datasets::Trajectory trajectory;
  evaluation::BodyFromSensor body_from_sensor;  ///< where the trajectory is of the body
};

/// Reads it and says what it is. @param path a trajectory, or the folder of a set
/// @param sensor EuRoC's sensor.yaml of the estimate's camera; "body": the estimate is of the body,
/// too; empty: cam0's of the set where its truth is the body's
/// @throws UserError where one of them cannot be read
[[nodiscard]] OdometryTruth read_truth(const std::string& path, const std::string& sensor,
                                       datasets::KittiTimes times);

}  // namespace striate::app
