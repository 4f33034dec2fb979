#pragma once

#include <optional>
#include <string>

#include "striate/config/diagnostics.hpp"
#include "striate/config/node.hpp"
#include "striate/platform/datasets/calibration/camera_model.hpp"

/// Reading the parts that calibrations of all programs have in common. Each adds a mistake with its
/// place where a value is not what it must be.
namespace striate::datasets {

/// Exactly Rows * Cols numbers.
template <int Rows, int Cols>
[[nodiscard]] std::optional<cv::Matx<double, Rows, Cols>> matrix_of(
    const config::Node& node, const std::string& what, config::Diagnostics& diagnostics);

extern template std::optional<cv::Matx33d> matrix_of<3, 3>(const config::Node&, const std::string&,
                                                           config::Diagnostics&);
extern template std::optional<cv::Matx34d> matrix_of<3, 4>(const config::Node&, const std::string&,
                                                           config::Diagnostics&);
extern template std::optional<cv::Matx44d> matrix_of<4, 4>(const config::Node&, const std::string&,
                                                           config::Diagnostics&);
extern template std::optional<cv::Matx31d> matrix_of<3, 1>(const config::Node&, const std::string&,
                                                           config::Diagnostics&);
extern template std::optional<cv::Matx41d> matrix_of<4, 1>(const config::Node&, const std::string&,
                                                           config::Diagnostics&);

/// One number that stands alone; nothing, without a mistake, where there is no node.
[[nodiscard]] std::optional<double> number_in(const config::Node* node, const std::string& what,
                                              config::Diagnostics& diagnostics);

/// fx, fy, cx, cy in px as a matrix.
[[nodiscard]] cv::Matx33d camera_matrix(double fx_px, double fy_px, double cx_px, double cy_px);
[[nodiscard]] std::optional<cv::Matx33d> matrix_of_four(const config::Node& node,
                                                        config::Diagnostics& diagnostics);

/// Sets lens and coefficients. @param model "plumb_bob", "radtan", "equidistant", ...; "": not told
void set_distortion(const config::Node* coefficients, const config::Node* model, EyeModel& eye,
                    config::Diagnostics& diagnostics);

/// Width and height in px, whole and above 0.
[[nodiscard]] cv::Size size_of(const config::Node* width, const config::Node* height,
                               config::Diagnostics& diagnostics);

/// A rigid motion of 4x4 numbers, last row 0 0 0 1.
[[nodiscard]] std::optional<cv::Matx44d> motion_of(const config::Node& node,
                                                   const std::string& what,
                                                   config::Diagnostics& diagnostics);
[[nodiscard]] cv::Matx44d inverse_motion(const cv::Matx44d& motion);
[[nodiscard]] EyesApart apart_of(const cv::Matx44d& right_from_left);

/// Letters and digits alone, in lower case: "Camera_Matrix 1" is "cameramatrix1".
[[nodiscard]] std::string lower_letters(const std::string& text);

}  // namespace striate::datasets
