#include "striate/platform/interface/align_eyes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace striate {

void align_eyes(StereoFrame& frame, const RightEye& right) {
  // px: a tenth of what the matcher can tell; printed calibrations round to less
  constexpr double kSame_px = 0.01;
  // Share of the focal length: eyes of one rectified pair have the same; by hand, for rounding and
  // calibrations of another make
  constexpr double kOtherLens = 0.2;
  if (frame.right.empty()) return;
  // A pixel of the new image and where it is in the given one.
  const bool known = right.focal_px > 0.0 && frame.focal_px > 0.0;
  const double scale = known ? right.focal_px / frame.focal_px : 1.0;
  const auto source = [&](double px, double centre_px, double right_centre_px) {
    return right_centre_px + scale * (px - centre_px);
  };
  const double from_u_px = source(0.0, frame.centre_u_px, right.centre_u_px);
  const double from_v_px = source(0.0, frame.centre_v_px, right.centre_v_px);
  const double stretch_px = std::abs(scale - 1.0) * frame.right.cols;
  if (std::abs(from_u_px) < kSame_px && std::abs(from_v_px) < kSame_px && stretch_px < kSame_px) {
    return;
  }
  const bool possible = std::abs(scale - 1.0) < kOtherLens &&
                        std::abs(from_u_px) < frame.right.cols &&
                        std::abs(from_v_px) < frame.right.rows;
  if (!possible) {
    throw std::runtime_error(fmt::format(
        "the right eye's focal length and principal point ({:.6g}; {:.6g}, {:.6g} px) do not go "
        "with the left one's ({:.6g}; {:.6g}, {:.6g} px)",
        right.focal_px, right.centre_u_px, right.centre_v_px, frame.focal_px, frame.centre_u_px,
        frame.centre_v_px));
  }
  const cv::Matx23d way(scale, 0.0, from_u_px, 0.0, scale, from_v_px);
  cv::Mat3b moved;
  cv::warpAffine(frame.right, moved, way, frame.right.size(),
                 cv::INTER_CUBIC | cv::WARP_INVERSE_MAP, cv::BORDER_REPLICATE);
  frame.right = moved;
}

}  // namespace striate
