#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>

#include "app/perceive.hpp"
#include "perception/percept.hpp"
#include "platform/interface/senses.hpp"

/// Writing what `striate perceive` found.
namespace striate {

/// How the obstacles of obstacles.json came about.
struct ObstacleReport {
  std::string method;
  std::string unit;            ///< of every length: "m" or "baselines"
  std::string threshold_from;  ///< empty where no threshold was used
  double threshold_px = 0.0;
  bool floor_known = false;
};

void write_pfm(const std::filesystem::path& file, const cv::Mat1f& values);
void write_picture(const std::filesystem::path& file, const cv::Mat3b& picture);

/// Before the work that the picture is to show; an empty path asks for nothing.
/// @throws UserError where nothing can be written there, or the name's end is no kind of picture
void check_picture_writable(const std::string& file);

[[nodiscard]] std::string obstacles_json(const Percept& percept, const PerceiveOptions& options,
                                         const ObstacleReport& report);
[[nodiscard]] std::string keypoints_json(const Percept& percept, cv::Size picture);

/// The heat map alone, at the picture's own size (at least 640 wide).
[[nodiscard]] cv::Mat3b saliency_picture(const StereoFrame& frame, const Percept& percept);

}  // namespace striate
