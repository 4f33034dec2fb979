#include "striate/agent/teaching/image_view.hpp"

#include <algorithm>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "striate/memory/long_term/view_codec.hpp"
#include "striate/perception/recognition/landmark_view.hpp"
#include "striate/perception/recognition/oriented_keypoints.hpp"

namespace striate::agent {
namespace {

constexpr int kShortestSide_px = 16;  ///< below it there is nothing to look for
constexpr int kJpegQuality = 90;      ///< of 100: so mild that no blocks are seen (ours)

void keep_inside(const cv::Mat1b& inside, const cv::Size& size,
                 std::vector<perception::Keypoint>& points) {
  cv::Mat1b small;
  cv::resize(inside, small, size, 0.0, 0.0, cv::INTER_NEAREST);
  std::erase_if(points, [&](const perception::Keypoint& point) {
    return small(std::clamp(cvRound(point.v_px), 0, size.height - 1),
                 std::clamp(cvRound(point.u_px), 0, size.width - 1)) == 0;
  });
}

/// From afar only the large keypoints are seen, from near only the small ones find their like. So
/// each size has its share, however large the picture was: the strongest of all sizes in turn.
void keep_strongest_of_each_size(std::vector<perception::Keypoint>& points, std::size_t most) {
  std::stable_sort(points.begin(), points.end(),
                   [](const perception::Keypoint& a, const perception::Keypoint& b) {
                     return a.response > b.response;
                   });
  std::map<double, std::size_t> seen;  // of each size
  std::vector<std::pair<std::size_t, std::size_t>> turns;
  for (std::size_t k = 0; k < points.size(); ++k) {
    turns.emplace_back(seen[points[k].wavelength_px]++, k);
  }
  std::ranges::sort(turns);
  if (turns.size() > most) turns.resize(most);
  std::vector<perception::Keypoint> kept;
  for (const auto& [turn, k] : turns) kept.push_back(points[k]);
  points = std::move(kept);
}

perception::ViewKeypoint stored(const perception::Keypoint& point) {
  return {static_cast<float>(point.u_px), static_cast<float>(point.v_px),
          static_cast<float>(point.wavelength_px), static_cast<float>(point.angle_rad)};
}

}  // namespace

cv::Mat3b picture_to_learn(const cv::Mat3b& image) {
  const int side = std::max(image.cols, image.rows);
  if (side <= perception::kLongestView_px) return image;
  const double scale = static_cast<double>(perception::kLongestView_px) / side;
  cv::Mat3b small;
  // A strip a pixel high stays one pixel high.
  const cv::Size size(std::max(1, cvRound(scale * image.cols)),
                      std::max(1, cvRound(scale * image.rows)));
  cv::resize(image, small, size, 0.0, 0.0, cv::INTER_AREA);
  return small;
}

std::vector<perception::Keypoint> keypoints_to_learn(const cv::Mat1b& grey) {
  return perception::OrientedKeypoints(perception::OrientedSettings{})(grey);
}

memory::StoredView view_of_image(const cv::Mat3b& image, const memory::LongTermSettings& settings,
                                 const cv::Mat1b& inside) {
  const cv::Mat3b small = picture_to_learn(image);
  memory::StoredView view;
  view.width_px = small.cols;
  view.height_px = small.rows;
  cv::imencode(".jpg", small, view.image, {cv::IMWRITE_JPEG_QUALITY, kJpegQuality});
  if (std::min(small.cols, small.rows) < kShortestSide_px) return view;
  cv::Mat1b grey;
  cv::cvtColor(small, grey, cv::COLOR_BGR2GRAY);
  std::vector<perception::Keypoint> points = keypoints_to_learn(grey);
  if (!inside.empty()) keep_inside(inside, small.size(), points);
  keep_strongest_of_each_size(points, static_cast<std::size_t>(settings.most_keypoints));
  for (const perception::Keypoint& point : points) {
    view.keypoints.push_back(stored(point));
    view.descriptors.push_back(memory::stored(point.descriptor));
  }
  return view;
}

}  // namespace striate::agent
