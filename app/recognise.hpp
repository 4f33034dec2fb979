#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "striate/perception/recognition/recognition_settings.hpp"
#include "striate/platform/datasets/sequences/sequence.hpp"

namespace striate::app {

/// What `striate recognise` is asked.
struct RecogniseOptions {
  std::filesystem::path source;  ///< picture, folder, video or sequence
  datasets::SequenceOptions sequence;
  std::string memory = "home.db";
  std::vector<std::string> only;  ///< names that are looked for; empty: all
  std::filesystem::path out;      ///< folder for annotated pictures; empty: none
  bool json = false;
  bool rectified = false;
  double focal_px = 0.0;  ///< without a calibration, of rectified pairs
  double baseline_m = 0.0;
  perception::RecognitionSettings settings;
  std::function<bool()> stopped;
};

/// Says of each picture which landmarks of the memory are where, and of all pictures which were
/// never seen.
/// @return 0 where something was recognised, 1 where nothing was, 130 where it was stopped
/// @throws UserError where the memory is missing or knows no landmark, or there are no pictures
int recognise(const RecogniseOptions& options);

}  // namespace striate::app
