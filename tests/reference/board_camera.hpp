#pragma once

#include <opencv2/calib3d.hpp>
#include <opencv2/core.hpp>
#include <vector>

#include "striate/platform/pioneer/camera/stereo_calibration.hpp"

namespace striate::reference {

/// Draws a chessboard as a camera with a known lens sees it, ray by ray.
class BoardCamera {
 public:
  BoardCamera(const pioneer::CameraModel& camera, cv::Size size_px) : size_px_(size_px) {
    std::vector<cv::Point2f> pixels;
    for (int v = 0; v < size_px.height * kSamples; ++v) {
      for (int u = 0; u < size_px.width * kSamples; ++u) {
        pixels.emplace_back((static_cast<float>(u) + 0.5F) / kSamples - 0.5F,
                            (static_cast<float>(v) + 0.5F) / kSamples - 0.5F);
      }
    }
    cv::undistortPoints(pixels, rays_, camera.matrix, camera.distortion);
  }

  /// @param turn, way: from the board's frame to the camera's. Outside of the board it is grey.
  [[nodiscard]] cv::Mat1b image(int columns, int rows, double square_m, const cv::Matx33d& turn,
                                const cv::Vec3d& way) const {
    const cv::Matx33d back = turn.t();
    const cv::Vec3d eye = back * (-way);
    cv::Mat1f light(size_px_, 0.0F);
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      const cv::Vec3d ray = back * cv::Vec3d(rays_[i].x, rays_[i].y, 1.0);
      const double along = -eye[2] / ray[2];
      const double column = (eye[0] + along * ray[0]) / square_m + 1.0;
      const double row = (eye[1] + along * ray[1]) / square_m + 1.0;
      const bool on_white =
          column > -1.0 && column < columns + 2.0 && row > -1.0 && row < rows + 2.0;
      const bool on_board = column > 0.0 && column < columns + 1.0 && row > 0.0 && row < rows + 1.0;
      const bool dark = (static_cast<int>(column) + static_cast<int>(row)) % 2 == 0;
      const float value = on_board ? (dark ? 30.0F : 220.0F) : (on_white ? 220.0F : 120.0F);
      const int width = size_px_.width * kSamples;
      const int at = static_cast<int>(i);
      light(at / width / kSamples, at % width / kSamples) += value / (kSamples * kSamples);
    }
    cv::Mat1b image;
    light.convertTo(image, CV_8U);
    return image;
  }

 private:
  static constexpr int kSamples = 3;
  cv::Size size_px_;
  std::vector<cv::Point2f> rays_;
};

}  // namespace striate::reference
