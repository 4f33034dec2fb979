#include "striate/evaluation/images/set_files.hpp"

#include <cmath>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "striate/base/user_error.hpp"

namespace striate::evaluation {

cv::Mat1b read_values(const std::filesystem::path& file) {
  cv::Mat1b image = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
  if (image.empty()) throw UserError(file.string() + ": cannot be read as an image");
  return image;
}

cv::Matx33d read_homography(const std::filesystem::path& file) {
  std::ifstream stream(file);
  cv::Matx33d homography;
  for (double& value : homography.val) stream >> value;
  if (!stream || !std::isfinite(cv::norm(homography)) || cv::determinant(homography) == 0.0) {
    throw UserError(file.string() + ": not a homography: nine numbers, row by row, are expected");
  }
  return homography;
}

}  // namespace striate::evaluation
