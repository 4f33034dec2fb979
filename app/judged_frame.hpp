#pragma once

#include "striate/app/perceive_files.hpp"
#include "striate/perception/percept.hpp"
#include "striate/platform/interface/robot.hpp"

namespace striate::app {

/// What the vision made of one pair of pictures.
struct JudgedFrame {
  perception::Percept percept;
  RobotDescription robot;
  ObstacleReport report;
};

}  // namespace striate::app
