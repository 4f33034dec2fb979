#include "striate/evaluation/odometry/camera_truth.hpp"

#include "striate/evaluation/odometry/odometry_scores.hpp"

namespace striate::evaluation {
namespace {

void invert_rotations(std::vector<PosePair>& pairs) {
  for (PosePair& pair : pairs) pair.truth.rotation = pair.truth.rotation.t();
}

/// How far the estimate's motions over half of the run are from the true ones, the median. Ways are
/// compared in the axes of either end: one that has not turned yet tells nothing.
MotionError motions_apart(std::vector<PosePair> pairs, const BodyFromSensor& body_from_sensor,
                          bool scale) {
  move_to_sensor(body_from_sensor, pairs);
  if (scale) {
    const double by = align(pairs, true).scale;
    for (PosePair& pair : pairs) pair.estimate.position_m *= by;
  }
  std::vector<double> ways_m, turns_rad;
  const std::size_t half = pairs.size() / 2;
  for (std::size_t k = 0; k + half < pairs.size(); ++k) {
    const MotionError there = motion_error(pairs[k], pairs[k + half]);
    const MotionError back = motion_error(pairs[k + half], pairs[k]);
    ways_m.push_back(there.way_m + back.way_m);
    turns_rad.push_back(there.turn_rad);
  }
  return {figures_of(ways_m).median, figures_of(turns_rad).median};
}

}  // namespace

void move_to_sensor(const BodyFromSensor& body_from_sensor, std::vector<PosePair>& pairs) {
  if (!body_from_sensor) return;
  const cv::Matx33d turn = body_from_sensor->get_minor<3, 3>(0, 0);
  const cv::Vec3d way_m((*body_from_sensor)(0, 3), (*body_from_sensor)(1, 3),
                        (*body_from_sensor)(2, 3));
  for (PosePair& pair : pairs) {
    pair.truth.position_m += pair.truth.rotation * way_m;
    pair.truth.rotation = pair.truth.rotation * turn;
  }
}

bool rotations_are_inverted(const std::vector<PosePair>& pairs,
                            const BodyFromSensor& body_from_sensor, bool scale) {
  constexpr double kClearly_rad = 0.02;  // a degree: less is the estimate's own error (by hand)
  constexpr double kTurnsBetter = 5.0;   // ratio of the two errors (by hand)
  constexpr double kWaysBetter = 2.0;    // the same; an estimate's ways err more (by hand)
  std::vector<PosePair> inverted = pairs;
  invert_rotations(inverted);
  const MotionError as_said = motions_apart(pairs, body_from_sensor, scale);
  const MotionError other = motions_apart(inverted, body_from_sensor, scale);
  // Turns alone do not tell: on a plane those of a right truth in other axes are the inverse ones.
  return as_said.turn_rad > kClearly_rad && as_said.turn_rad > kTurnsBetter * other.turn_rad &&
         as_said.way_m > kWaysBetter * other.way_m;
}

void invert_truth_if_it_is(const BodyFromSensor& body_from_sensor, bool scale, PairedPoses& poses) {
  if (!rotations_are_inverted(poses.pairs, body_from_sensor, scale)) return;
  invert_rotations(poses.pairs);
  poses.remarks.emplace_back(
      "the truth's rotations are the inverse of the estimate's: taken for those of the world in "
      "the "
      "camera, not of the camera in the world as they should be, and inverted");
}

}  // namespace striate::evaluation
