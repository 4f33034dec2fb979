#pragma once

#include <optional>
#include <string>

#include "striate/config/diagnostics.hpp"
#include "striate/config/node.hpp"
#include "striate/platform/datasets/calibration/camera_model.hpp"

/// One reader a format: a file of one. Mistakes are added with their places; the caller judges.
namespace striate::datasets {

/// A file that tells one eye: with its place in the rig, or with its part of a rectified pair.
struct OneEye {
  std::string format;
  EyeModel eye;
  std::optional<cv::Matx44d> body_from_eye;  ///< EuRoC's T_BS
};

[[nodiscard]] bool is_camera_info(const config::Node& root);
[[nodiscard]] OneEye read_camera_info(const config::Node& root, config::Diagnostics& diagnostics);

[[nodiscard]] bool is_euroc_sensor(const config::Node& root);
[[nodiscard]] OneEye read_euroc_sensor(const config::Node& root, config::Diagnostics& diagnostics);

[[nodiscard]] bool is_kalibr(const config::Node& root);
[[nodiscard]] StereoModel read_kalibr(const config::Node& root, config::Diagnostics& diagnostics);

[[nodiscard]] bool is_boofcv(const config::Node& root);
[[nodiscard]] StereoModel read_boofcv(const config::Node& root, config::Diagnostics& diagnostics);

/// Any FileStorage or JSON whose keys say what they hold: K1, M1, cameraMatrix1,
/// left_camera_matrix, LEFT.K, {left: {K, D}}, ...; R, T; R1, P1; Q.
[[nodiscard]] bool is_named_matrices(const config::Node& root);
[[nodiscard]] StereoModel read_named_matrices(const config::Node& root,
                                              config::Diagnostics& diagnostics);

/// KITTI's calib.txt (P0: ...) or calib_cam_to_cam.txt (P_rect_00: ...).
/// @param first camera of the pair: 0 for the grey ones, 2 for those in colour
[[nodiscard]] bool is_kitti(const std::string& text);
[[nodiscard]] StereoModel read_kitti(const std::string& text, int first,
                                     config::Diagnostics& diagnostics);

/// Middlebury's calib.txt of 2014 and later: cam0=[f 0 cx; 0 f cy; 0 0 1], baseline in mm, doffs
[[nodiscard]] bool is_middlebury(const std::string& text);
[[nodiscard]] StereoModel read_middlebury(const std::string& text,
                                          config::Diagnostics& diagnostics);

}  // namespace striate::datasets
