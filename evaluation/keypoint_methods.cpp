#include "striate/evaluation/keypoint_methods.hpp"

#include <algorithm>
#include <opencv2/features2d.hpp>
#include <set>

#include "striate/perception/keypoints/keypoints.hpp"

namespace striate::evaluation {
namespace {

KeypointMethod striate_method(const std::string& name,
                              const perception::KeypointSettings& settings) {
  return {name, [settings](const cv::Mat1b& grey, int most) {
            perception::KeypointSettings limited = settings;
            limited.most = most;
            std::vector<cv::Point2d> places;
            for (const perception::Keypoint& point : perception::find_keypoints(grey, limited)) {
              places.emplace_back(point.u_px, point.v_px);
            }
            return places;
          }};
}

/// SIFT gives a place once for each of its directions: a place counts once.
std::vector<cv::Point2d> strongest(std::vector<cv::KeyPoint> found, int most) {
  std::ranges::stable_sort(found, std::ranges::greater{}, &cv::KeyPoint::response);
  std::vector<cv::Point2d> places;
  std::set<std::pair<float, float>> known;
  for (const cv::KeyPoint& point : found) {
    if (static_cast<int>(places.size()) == most) break;
    if (known.emplace(point.pt.x, point.pt.y).second) places.emplace_back(point.pt);
  }
  return places;
}

template <class Make>
KeypointMethod opencv_method(const std::string& name, Make make) {
  return {name, [make](const cv::Mat1b& grey, int most) {
            std::vector<cv::KeyPoint> found;
            make(most)->detect(grey, found);
            return strongest(std::move(found), most);
          }};
}

}  // namespace

perception::KeypointSettings all_scales(perception::EndStoppedResponse response) {
  perception::KeypointSettings settings;
  settings.wavelength_px = 4.0;
  settings.halve = false;
  settings.scales = 9;
  settings.threshold = 0.01;
  settings.response = response;
  return settings;
}

std::vector<KeypointMethod> keypoint_methods() {
  return {
      striate_method("Striate K_D", all_scales(perception::EndStoppedResponse::double_stopped)),
      striate_method("Striate max", all_scales(perception::EndStoppedResponse::largest)),
      striate_method("Striate lambda 8", perception::KeypointSettings{}),
      opencv_method("ORB", [](int most) { return cv::ORB::create(most); }),
      opencv_method("BRISK", [](int) { return cv::BRISK::create(30, 3); }),
      opencv_method(
          "AKAZE",
          [](int) { return cv::AKAZE::create(cv::AKAZE::DESCRIPTOR_MLDB, 0, 3, 0.0001F); }),
      opencv_method("SIFT", [](int) { return cv::SIFT::create(0, 3, 0.01); }),
  };
}

}  // namespace striate::evaluation
