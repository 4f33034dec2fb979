#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "striate/platform/datasets/calibration/camera_model.hpp"
#include "striate/platform/interface/senses.hpp"

namespace striate::datasets {

/// Makes pictures as two ideal cameras side by side would have taken them. What the calibration
/// says of rectified pictures (R1, P1, ...) is followed; where it says nothing, both eyes are
/// turned half of the way to each other and as much is kept as both saw: no black border. Keeps its
/// tables. One eye alone is made straight.
class PictureRectifier {
 public:
  /// @param pictures size of the pictures to come. Where the calibration is of another size of the
  /// same shape it is scaled, which remarks() tell.
  /// @param rectified they are rectified already, whatever the calibration is of
  /// @throws UserError where the shapes differ, or no part of the pictures is seen by both eyes
  PictureRectifier(const StereoModel& model, cv::Size pictures, bool rectified);

  /// Fills in images and the camera's numbers; leaves the rest. `right` may be empty.
  /// @throws UserError for pictures of another size
  void rectify(const cv::Mat3b& left, const cv::Mat3b& right, StereoFrame& frame) const;

  /// How far right of the left one's the right principal point lies in what comes out, px.
  [[nodiscard]] double doffs_px() const { return doffs_px_; }
  /// How the left eye was turned: from the raw camera's axes to those of what comes out.
  [[nodiscard]] const cv::Matx33d& left_turn() const { return left_turn_; }
  [[nodiscard]] double focal_px() const { return focal_px_; }
  [[nodiscard]] double baseline_m() const { return baseline_m_; }
  [[nodiscard]] bool changes_pictures() const { return !eyes_[0].map_1.empty(); }
  [[nodiscard]] const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  struct Eye {
    cv::Mat map_1;  ///< empty: the picture stays as it is
    cv::Mat map_2;
  };
  void take_as_rectified(const StereoModel& model);
  void follow_file(const StereoModel& model);
  void make_own(const StereoModel& model);
  void make_maps(const EyeModel& eye, const cv::Matx33d& turn, const cv::Matx34d& projection,
                 Eye& to) const;

  cv::Size size_;
  std::array<Eye, 2> eyes_;
  double focal_px_ = 0.0;
  double centre_u_px_ = 0.0;
  double centre_v_px_ = 0.0;
  double baseline_m_ = 0.0;
  double doffs_px_ = 0.0;
  cv::Matx33d left_turn_ = cv::Matx33d::eye();
  std::vector<std::string> remarks_;
};

}  // namespace striate::datasets
