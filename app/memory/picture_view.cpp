#include "app/memory/picture_view.hpp"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "memory/long_term/view_codec.hpp"
#include "perception/recognition/oriented_keypoints.hpp"

namespace striate {
namespace {

/// px: the size recognition was measured at (jsk_arc2017, 640 x 480)
constexpr int kLongestSide_px = 640;
constexpr int kShortestSide_px = 16;  ///< below it there is nothing to look for
constexpr int kJpegQuality = 90;      ///< of 100: so mild that no blocks are seen (ours)

cv::Mat3b shrunk(const cv::Mat3b& picture) {
  const int side = std::max(picture.cols, picture.rows);
  if (side <= kLongestSide_px) return picture;
  const double scale = static_cast<double>(kLongestSide_px) / side;
  cv::Mat3b small;
  // A strip a pixel high stays one pixel high.
  const cv::Size size(std::max(1, cvRound(scale * picture.cols)),
                      std::max(1, cvRound(scale * picture.rows)));
  cv::resize(picture, small, size, 0.0, 0.0, cv::INTER_AREA);
  return small;
}

StoredKeypoint stored(const Keypoint& point) {
  return {static_cast<float>(point.u_px), static_cast<float>(point.v_px),
          static_cast<float>(point.wavelength_px), static_cast<float>(point.angle_rad)};
}

}  // namespace

std::vector<Keypoint> keypoints_to_learn(const cv::Mat1b& grey) {
  return OrientedKeypoints(OrientedSettings{})(grey);
}

StoredView view_of_picture(const cv::Mat3b& picture, const LongTermSettings& settings) {
  const cv::Mat3b small = shrunk(picture);
  StoredView view;
  view.width_px = small.cols;
  view.height_px = small.rows;
  cv::imencode(".jpg", small, view.picture, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  if (std::min(small.cols, small.rows) < kShortestSide_px) return view;
  cv::Mat1b grey;
  cv::cvtColor(small, grey, cv::COLOR_BGR2GRAY);
  std::vector<Keypoint> points = keypoints_to_learn(grey);
  std::stable_sort(points.begin(), points.end(),
                   [](const Keypoint& a, const Keypoint& b) { return a.response > b.response; });
  if (static_cast<int>(points.size()) > settings.most_keypoints) {
    points.resize(static_cast<std::size_t>(settings.most_keypoints));
  }
  for (const Keypoint& point : points) {
    view.keypoints.push_back(stored(point));
    view.descriptors.push_back(striate::stored(point.descriptor));
  }
  return view;
}

}  // namespace striate
