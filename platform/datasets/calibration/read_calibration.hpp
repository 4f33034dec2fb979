#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "striate/platform/datasets/calibration/camera_model.hpp"

namespace striate::datasets {

/// Reads what calibration programs write, told apart by what is in it, never by its name: Striate's
/// own and any OpenCV FileStorage (YAML, XML, JSON), ROS camera_info (the file, and what `rostopic
/// echo` or `ros2 topic echo` print), Kalibr's camchain, EuRoC's sensor.yaml, KITTI's calib.txt and
/// calib_cam_to_cam.txt, Middlebury's calib.txt, BoofCV's XML. One file for both eyes, or two: the
/// left one's and the right one's. Units and conventions are judged; what was assumed is in the
/// remarks.
/// @param exchanged the eyes change places before anything is judged: a person said so
/// @throws UserError naming file, line and column
[[nodiscard]] StereoModel read_calibration(const std::vector<std::filesystem::path>& files,
                                           bool exchanged = false);

/// The same of texts, for tests. @param names for messages
[[nodiscard]] StereoModel read_calibration_text(const std::vector<std::string>& texts,
                                                const std::vector<std::string>& names,
                                                bool exchanged = false);

/// Whether a file of that content might be one at all, so that a folder can be searched.
[[nodiscard]] bool looks_like_calibration(const std::filesystem::path& file);

}  // namespace striate::datasets
