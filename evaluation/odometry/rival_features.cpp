#include "striate/evaluation/odometry/rival_features.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/features2d.hpp>

#include "striate/perception/visual_odometry/striate_features.hpp"

namespace striate::evaluation {
namespace {

using perception::DescriptorMetric;
using perception::Feature;
using perception::FeatureSet;

constexpr int kRivalKeypoints = 4000;  // as many as StriateFeatures chooses from

/// @param scale_of of a keypoint, 1 for the finest
template <class Scale>
void find_with(cv::Feature2D& finder, const cv::Mat1b& grey, int most, Scale scale_of,
               FeatureSet& out) {
  std::vector<cv::KeyPoint> found;
  finder.detect(grey, found);
  // SIFT gives a place once for each of its directions: here one is enough, the first.
  std::ranges::stable_sort(found, [](const cv::KeyPoint& a, const cv::KeyPoint& b) {
    return a.pt.y != b.pt.y ? a.pt.y < b.pt.y : a.pt.x < b.pt.x;
  });
  const auto again = std::ranges::unique(
      found, {}, [](const cv::KeyPoint& p) { return std::pair(p.pt.x, p.pt.y); });
  found.erase(again.begin(), again.end());
  std::vector<Feature> all;
  for (const cv::KeyPoint& point : found) {
    all.push_back({point.pt.x, point.pt.y, scale_of(point), point.response});
  }
  std::vector<cv::KeyPoint> kept;
  for (const std::size_t k : perception::spread_evenly(all, grey.size(), most)) {
    kept.push_back(found[k]);
  }
  cv::Mat descriptors;
  finder.compute(grey, kept, descriptors);  // leaves out what is too near the border
  out.features.clear();
  for (const cv::KeyPoint& point : kept) {
    out.features.push_back({point.pt.x, point.pt.y, scale_of(point), point.response});
  }
  cv::Mat1b bytes;
  descriptors.convertTo(bytes, CV_8U);      // SIFT's numbers are whole, 0..255
  const std::size_t count = bytes.total();  // 0 without keypoints: the matrix has no columns then
  if (count > 0) out.bytes = bytes.cols;
  out.descriptors.assign(bytes.data, bytes.data + count);
}

perception::FeatureSource orb_source() {
  constexpr double kOrbDistance =
      64.0;                        // bits of 256: as ORB-SLAM takes them for the same (50 to 100)
  constexpr float kOctave = 1.2F;  // ratio of two sizes; OpenCV's own
  constexpr int kFastThreshold = 10;  // grey levels; OpenCV's 20 leaves too few in dim images
  const cv::Ptr<cv::ORB> orb = cv::ORB::create(kRivalKeypoints, kOctave, 8, 31, 0, 2,
                                               cv::ORB::HARRIS_SCORE, 31, kFastThreshold);
  return [orb](const cv::Mat1b& grey, int most, FeatureSet& out) {
    out.metric = DescriptorMetric::hamming;
    out.most_distance = kOrbDistance;
    find_with(
        *orb, grey, most,
        [](const cv::KeyPoint& p) { return std::pow(static_cast<double>(kOctave), p.octave); },
        out);
  };
}

perception::FeatureSource sift_source() {
  constexpr double kSiftDistance =
      300.0;                          // of numbers 0..255: true pairs are usually below (by hand)
  constexpr double kFinest_px = 2.0;  // diameter of SIFT's smallest keypoints
  constexpr double kContrast = 0.01;  // as in `striate eval keypoints`; OpenCV's 0.04 leaves few
  const cv::Ptr<cv::SIFT> sift = cv::SIFT::create(0, 3, kContrast);
  return [sift](const cv::Mat1b& grey, int most, FeatureSet& out) {
    out.metric = DescriptorMetric::euclidean;
    out.most_distance = kSiftDistance;
    find_with(
        *sift, grey, most, [](const cv::KeyPoint& p) { return std::max(1.0, p.size / kFinest_px); },
        out);
  };
}

}  // namespace

std::vector<OdometryMethod> odometry_methods() {
  return {
      {"Striate", perception::striate_features()}, {"ORB", orb_source()}, {"SIFT", sift_source()}};
}

}  // namespace striate::evaluation
