#pragma once

#include <filesystem>
#include <opencv2/core/matx.hpp>

namespace striate::datasets {

/// T_BS of EuRoC's sensor.yaml: takes a point of the sensor to the body's frame.
/// @throws UserError where the file tells none
[[nodiscard]] cv::Matx44d read_sensor_place(const std::filesystem::path& file);

}  // namespace striate::datasets
