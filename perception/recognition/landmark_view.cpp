#include "striate/perception/recognition/landmark_view.hpp"

#include "striate/base/user_error.hpp"

namespace striate::perception {

LandmarkView make_view(const cv::Mat1b& grey, const cv::Rect& region, const KeypointSource& find) {
  const cv::Rect part = region & cv::Rect(0, 0, grey.cols, grey.rows);
  if (part.empty()) throw UserError("a view's region lies outside its image");
  LandmarkView view;
  view.width_px = part.width;
  view.height_px = part.height;
  for (const Keypoint& point : find(grey)) {
    const double x_px = point.u_px - part.x, y_px = point.v_px - part.y;
    const bool within =
        x_px >= -0.5 && x_px < part.width - 0.5 && y_px >= -0.5 && y_px < part.height - 0.5;
    if (!within) continue;
    view.descriptors.push_back(point.descriptor);
    view.keypoints.push_back({static_cast<float>(x_px), static_cast<float>(y_px),
                              static_cast<float>(point.wavelength_px),
                              static_cast<float>(point.angle_rad)});
  }
  return view;
}

}  // namespace striate::perception
