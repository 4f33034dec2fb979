#pragma once

#include <functional>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "perception/percept.hpp"

namespace striate {

/// How a picture becomes keypoints. The same one must teach and recognise.
using KeypointSource = std::function<std::vector<Keypoint>(const cv::Mat1b&)>;

/// One side of an object as it was taught.
struct ObjectView {
  std::vector<Keypoint> keypoints;  ///< places relative to the upper left pixel of the region
  double width_px = 0.0;            ///< of the region
  double height_px = 0.0;
};

struct ObjectModel {
  std::string name;
  std::vector<ObjectView> views;
};

/// A view of what `region` of a picture shows; the keypoints are those of the region alone, with
/// the surroundings at its rim. @throws UserError where the region has no pixel of the picture.
[[nodiscard]] ObjectView make_view(const cv::Mat1b& grey, const cv::Rect& region,
                                   const KeypointSource& find);

/// The same view turned in the picture plane, `count` times by 360 / count degrees, the first as it
/// is: for descriptors that do not turn with the picture. The surroundings turn too, but their
/// keypoints are left out.
[[nodiscard]] std::vector<ObjectView> make_turned_views(const cv::Mat1b& grey,
                                                        const cv::Rect& region, int count,
                                                        const KeypointSource& find);

}  // namespace striate
