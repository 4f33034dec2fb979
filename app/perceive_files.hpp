#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "striate/app/perceive_options.hpp"
#include "striate/perception/percept.hpp"
#include "striate/platform/interface/senses.hpp"

/// Writing what `striate perceive` found.
namespace striate::app {

/// How the obstacles of obstacles.json came about.
struct ObstacleReport {
  std::string method;
  std::string unit;            ///< of every length: "m" or "baselines"
  std::string threshold_from;  ///< empty where no threshold was used
  double threshold_px = 0.0;
  /// Px of the working size: how far right of the left one's the right principal point lies. Every
  /// disparity in the files is one of the images as they were given: Z = f B / (d + doffs).
  double doffs_px = 0.0;
  bool floor_known = false;
  std::vector<std::string> warnings;  ///< what speaks against the pair
};

void write_pfm(const std::filesystem::path& file, const cv::Mat1f& values);
void write_picture(const std::filesystem::path& file, const cv::Mat3b& image);

/// Before the work that the image is to show; an empty path asks for nothing.
/// @throws UserError where nothing can be written there, or the name's end is no kind of image
void check_image_writable(const std::string& file);

[[nodiscard]] std::string obstacles_json(const perception::Percept& percept,
                                         const PerceiveOptions& options,
                                         const ObstacleReport& report);
[[nodiscard]] std::string keypoints_json(const perception::Percept& percept, cv::Size image);

/// The heat map alone, at the image's own size (at least 640 wide).
[[nodiscard]] cv::Mat3b saliency_picture(const StereoFrame& frame,
                                         const perception::Percept& percept);

}  // namespace striate::app
