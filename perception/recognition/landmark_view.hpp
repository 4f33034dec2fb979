#pragma once

#include <functional>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "striate/perception/percept.hpp"

namespace striate::perception {

/// Where a keypoint of a view is: 16 bytes, as they may be stored.
struct ViewKeypoint {
  float x_px = 0.0F;  ///< from the view's upper left pixel, whose centre is (0, 0); x right, y down
  float y_px = 0.0F;
  float size_px = 0.0F;    ///< the keypoint's wavelength, in pixels of the view; above 0
  float angle_rad = 0.0F;  ///< from +x towards +y
  friend bool operator==(const ViewKeypoint&, const ViewKeypoint&) = default;
};
static_assert(sizeof(ViewKeypoint) == 16 && sizeof(Descriptor) == 32);

/// Pictures to teach from are shrunk to this longest side: recognition was measured at it
/// (jsk_arc2017, 640 x 480).
inline constexpr int kLongestView_px = 640;

/// One view of a landmark as it was taught. Both arrays can be stored as they lie in memory.
struct LandmarkView {
  std::vector<Descriptor> descriptors;  ///< Striate's own, 32 bytes each
  std::vector<ViewKeypoint> keypoints;  ///< of each descriptor: the same number
  double width_px = 0.0;                ///< of the region that the view shows; above 0
  double height_px = 0.0;
};

/// How an image becomes keypoints. The same one must teach and recognise.
using KeypointSource = std::function<std::vector<Keypoint>(const cv::Mat1b&)>;

/// A view of what `region` of an image shows; the keypoints are those of the region alone, with
/// the surroundings at its rim. @throws UserError where the region has no pixel of the image.
[[nodiscard]] LandmarkView make_view(const cv::Mat1b& grey, const cv::Rect& region,
                                     const KeypointSource& find);

}  // namespace striate::perception
