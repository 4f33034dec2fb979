#pragma once

#include <functional>
#include <string>

#include "striate/evaluation/odometry/eval_odometry.hpp"
#include "striate/perception/visual_odometry/odometry_settings.hpp"
#include "striate/platform/datasets/sequences/sequence.hpp"

namespace striate::app {

/// What visual odometry is asked of a sequence.
struct SequenceOdometryOptions {
  std::string source;  ///< folder, video or sequence
  datasets::SequenceOptions sequence;
  bool rectified = false;  ///< the pictures are rectified already
  perception::VisualOdometrySettings odometry;
  std::string out;  ///< a TUM file (`striate odometry`) or a folder (`eval odometry`); empty: none
  bool json = false;
  std::function<bool()> stopped;  ///< asked before each view; empty: never
};

/// Is it pictures, and no trajectory?
[[nodiscard]] bool is_sequence(const std::string& path);

/// `striate odometry`: a line for each view, and the trajectory as TUM.
/// @return 0; 1 where no view had an estimate; 130 where it was stopped
int tell_odometry(const SequenceOdometryOptions& options);

struct JudgedSequence {
  std::string truth;   ///< empty: the sequence's own, if it has one
  std::string sensor;  ///< as read_truth() takes it
  evaluation::OdometryOptions scores;
};

/// `striate eval odometry SEQUENCE`: with Striate's features, ORB's and SIFT's, against the truth.
/// @return 0; 1 where no view of any had an estimate; 130 where it was stopped
/// @throws UserError where there is a truth and no run can be judged by it, after all was written
int compare_odometry(const SequenceOdometryOptions& options, const JudgedSequence& judged);

}  // namespace striate::app
