#pragma once

#include <string>

#include "striate/app/judged_frame.hpp"
#include "striate/app/perceive_options.hpp"
#include "striate/platform/interface/senses.hpp"

/// One pair of pictures as `striate perceive` sees it, wherever it comes from.
namespace striate::app {

/// @throws UserError for options that cannot be, whatever the picture
void check_perceive(const PerceiveOptions& options);

/// Gives a frame with pictures the camera that the options tell, and aligns its eyes.
/// @param name of the picture, for messages. @throws UserError where it can be no camera's
void place_camera(const PerceiveOptions& options, const std::string& name, StereoFrame& frame);

[[nodiscard]] JudgedFrame judge_frame(const PerceiveOptions& options, const StereoFrame& frame);

/// Says in the report, and where `aloud` on standard error, what speaks against the two being a
/// pair.
void warn_of_the_pair(const StereoFrame& frame, ObstacleReport& report, bool aloud = true);

/// All files of one frame into options.out. @param mark stands behind each name, before its suffix
void write_judged(const PerceiveOptions& options, const StereoFrame& frame,
                  const JudgedFrame& judged, const std::string& mark = {});

}  // namespace striate::app
