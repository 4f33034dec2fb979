#include "perception/recognition/object_model.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "config/user_error.hpp"

namespace striate {
namespace {

cv::Rect inside(const cv::Mat1b& grey, const cv::Rect& region) {
  const cv::Rect part = region & cv::Rect(0, 0, grey.cols, grey.rows);
  if (part.empty()) throw UserError("a view's region lies outside its picture");
  return part;
}

}  // namespace

ObjectView make_view(const cv::Mat1b& grey, const cv::Rect& region, const KeypointSource& find) {
  const cv::Rect part = inside(grey, region);
  ObjectView view;
  view.width_px = part.width;
  view.height_px = part.height;
  for (Keypoint point : find(grey)) {
    point.u_px -= part.x;
    point.v_px -= part.y;
    const bool within = point.u_px >= -0.5 && point.u_px < part.width - 0.5 && point.v_px >= -0.5 &&
                        point.v_px < part.height - 0.5;
    if (within) view.keypoints.push_back(point);
  }
  return view;
}

std::vector<ObjectView> make_turned_views(const cv::Mat1b& grey, const cv::Rect& region, int count,
                                          const KeypointSource& find) {
  const cv::Rect part = inside(grey, region);
  const cv::Size2f size(part.size());
  const cv::Point2f centre(static_cast<float>(part.x) + (size.width - 1) / 2,
                           static_cast<float>(part.y) + (size.height - 1) / 2);
  std::vector<ObjectView> views = {make_view(grey, part, find)};
  for (int k = 1; k < count; ++k) {
    const double angle_deg = 360.0 * k / count;
    const cv::Size around =
        cv::RotatedRect(centre, size, static_cast<float>(angle_deg)).boundingRect().size();
    cv::Mat1d turn = cv::getRotationMatrix2D(centre, angle_deg, 1.0);
    turn(0, 2) += (around.width - 1) / 2.0 - centre.x;
    turn(1, 2) += (around.height - 1) / 2.0 - centre.y;
    cv::Mat1b turned;
    cv::warpAffine(grey, turned, turn, around, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    ObjectView view = make_view(turned, {{0, 0}, around}, find);
    cv::Mat1d back;
    cv::invertAffineTransform(turn, back);
    std::erase_if(view.keypoints, [&](const Keypoint& point) {
      const double u = back(0, 0) * point.u_px + back(0, 1) * point.v_px + back(0, 2) - part.x;
      const double v = back(1, 0) * point.u_px + back(1, 1) * point.v_px + back(1, 2) - part.y;
      return u < -0.5 || v < -0.5 || u >= part.width - 0.5 || v >= part.height - 0.5;
    });
    views.push_back(std::move(view));
  }
  return views;
}

}  // namespace striate
