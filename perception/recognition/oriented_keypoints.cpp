#include "perception/recognition/oriented_keypoints.hpp"

namespace striate {

OrientedKeypoints::OrientedKeypoints(const OrientedSettings& settings)
    : settings_(settings), finder_(settings.keypoints), describer_(StriateSettings{}) {}

void OrientedKeypoints::find(const cv::Mat1b& grey, std::vector<Keypoint>& out) {
  finder_.find(grey, found_);
  frames_.clear();
  for (const Keypoint& point : found_) {
    frames_.push_back(
        {point.u_px, point.v_px, settings_.size_per_wavelength * point.wavelength_px, 0.0});
  }
  describer_.prepare(grey);
  describer_.describe_oriented(frames_, settings_.second_angle, turned_, descriptors_);
  out.clear();
  std::size_t from = 0;
  for (std::size_t k = 0; k < turned_.size(); ++k) {
    // A frame that stands twice has the same place both times.
    while (found_[from].u_px != turned_[k].u_px || found_[from].v_px != turned_[k].v_px) ++from;
    out.push_back(found_[from]);
    out.back().angle_rad = turned_[k].angle_rad;
    out.back().descriptor = descriptors_[k];
  }
}

std::vector<Keypoint> OrientedKeypoints::operator()(const cv::Mat1b& grey) {
  std::vector<Keypoint> points;
  find(grey, points);
  return points;
}

}  // namespace striate
