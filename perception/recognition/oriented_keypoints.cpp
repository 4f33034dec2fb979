#include "striate/perception/recognition/oriented_keypoints.hpp"

namespace striate::perception {
namespace {

bool same_frame(const Keypoint& point, const DescribedFrame& frame) {
  return point.u_px == frame.u_px && point.v_px == frame.v_px;
}

}  // namespace

OrientedKeypoints::OrientedKeypoints(const OrientedSettings& settings)
    : settings_(settings), finder_(settings.keypoints), describer_(StriateSettings{}) {}

void OrientedKeypoints::find(const cv::Mat1b& grey, std::vector<Keypoint>& out) {
  finder_.locate(grey, found_);
  describe(grey, found_, out);
}

void OrientedKeypoints::describe(const cv::Mat1b& grey, std::span<const Keypoint> found,
                                 std::vector<Keypoint>& out) {
  frames_.clear();
  for (const Keypoint& point : found) {
    frames_.push_back(
        {point.u_px, point.v_px, settings_.size_per_wavelength * point.wavelength_px, 0.0});
  }
  describer_.prepare(grey);
  describer_.describe_oriented(frames_, settings_.second_angle, turned_, descriptors_);
  out.clear();
  std::size_t from = 0;
  for (std::size_t k = 0; k < turned_.size(); ++k) {
    // A frame that stands twice has the same place both times.
    while (!same_frame(found[from], turned_[k])) ++from;
    out.push_back(found[from]);
    out.back().angle_rad = turned_[k].angle_rad;
    out.back().descriptor = descriptors_[k];
  }
}

std::vector<Keypoint> OrientedKeypoints::operator()(const cv::Mat1b& grey) {
  std::vector<Keypoint> points;
  find(grey, points);
  return points;
}

}  // namespace striate::perception
