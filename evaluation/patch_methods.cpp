#include "striate/evaluation/patch_methods.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "striate/base/index_within.hpp"

namespace striate::evaluation {
namespace {

/// Around a mosaic: a patch's side, so that no method drops one for being near the border
constexpr int kBorder_px = 64;
constexpr int kPatches = kMosaicPatches * kMosaicPatches;  // in one mosaic

/// Rows in the order of the patches, whatever the method left out (those stay zero).
cv::Mat rows_of(const cv::Ptr<cv::Feature2D>& method, const cv::Mat& image,
                std::vector<cv::KeyPoint>& frames) {
  std::vector<cv::KeyPoint> given = frames;
  cv::Mat described;
  method->compute(image, frames, described);
  cv::Mat rows = cv::Mat::zeros(static_cast<int>(given.size()), described.cols, described.type());
  std::size_t at = 0;
  for (int k = 0; k < described.rows; ++k, ++at) {
    while (frames[static_cast<std::size_t>(k)].pt != given[at].pt) ++at;
    described.row(k).copyTo(rows.row(static_cast<int>(at)));
  }
  return rows;
}

/// The mosaic with a margin, scaled; frames in the middles of its patches.
struct Scene {
  cv::Mat1b image;
  std::vector<cv::KeyPoint> frames;

  Scene(const cv::Mat1b& mosaic, int patches, double size_px, double scale = 1.0) {
    cv::Mat1b wide;
    cv::copyMakeBorder(mosaic, wide, kBorder_px, kBorder_px, kBorder_px, kBorder_px,
                       cv::BORDER_REPLICATE);
    cv::resize(wide, image, {}, scale, scale, scale < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
    const cv::Point2f margin(kBorder_px + 0.5F, kBorder_px + 0.5F);
    for (int k = 0; k < patches; ++k) {
      const cv::Point2f at = (patch_centre_px(k) + margin) * scale - cv::Point2f(0.5F, 0.5F);
      frames.emplace_back(at, static_cast<float>(size_px), 0.0F);
    }
  }
};

cv::Mat describe_orb(const cv::Mat1b& mosaic, int patches, double size_px) {
  // ORB knows only its own patch of 31 px: the image is scaled to it.
  Scene scene(mosaic, patches, 31.0, 31.0 / size_px);
  return rows_of(cv::ORB::create(kPatches, 1.2F, 1, 16), scene.image, scene.frames);
}

cv::Mat describe_brisk(const cv::Mat1b& mosaic, int patches, double size_px) {
  Scene scene(mosaic, patches, size_px);
  return rows_of(cv::BRISK::create(), scene.image, scene.frames);
}

cv::Mat describe_akaze(const cv::Mat1b& mosaic, int patches, double size_px) {
  Scene scene(mosaic, patches, size_px);
  // The frame's level of the scale space: size = 2 * 1.5 sigma, sigma = 1.6 * 2^(level / 4).
  const double level = 4.0 * std::log2(size_px / (2.0 * 1.5 * 1.6));
  for (cv::KeyPoint& frame : scene.frames) {
    frame.class_id = static_cast<int>(std::clamp(std::lround(level), 0L, 3L));
  }
  return rows_of(cv::AKAZE::create(), scene.image, scene.frames);
}

cv::Mat describe_sift(const cv::Mat1b& mosaic, int patches, double size_px) {
  Scene scene(mosaic, patches, size_px);
  // Octave and layer of the scale space: sigma = size / 2 = 1.6 * 2^(octave + layer / 3).
  const long level = std::max(0L, std::lround(3.0 * std::log2(size_px / 2.0 / 1.6)));
  for (cv::KeyPoint& frame : scene.frames) {
    frame.octave = static_cast<int>((level / 3) | (level % 3) << 8);
  }
  return rows_of(cv::SIFT::create(), scene.image, scene.frames);
}

/// Between the nearest two descriptions.
double distance_of_rows(const cv::Mat& a, const cv::Mat& b, int descriptions) {
  const int norm = a.depth() == CV_8U ? cv::NORM_HAMMING : cv::NORM_L2;
  const int values = a.cols / descriptions;
  double nearest = cv::norm(a.colRange(0, values), b.colRange(0, values), norm);
  for (int i = 0; i < descriptions; ++i) {
    for (int k = 0; k < descriptions; ++k) {
      const auto of_a = a.colRange(i * values, (i + 1) * values);
      const auto of_b = b.colRange(k * values, (k + 1) * values);
      nearest = std::min(nearest, cv::norm(of_a, of_b, norm));
    }
  }
  return nearest;
}

}  // namespace

std::vector<PatchMethod> opencv_patch_methods() {
  return {{"ORB", {40, 50, 62}, describe_orb, 1},
          {"BRISK", {8, 13, 16}, describe_brisk, 1},
          {"AKAZE", {4.8, 5.7}, describe_akaze, 1},
          {"SIFT", {6.4, 8, 10}, describe_sift, 1}};
}

std::vector<float> pair_distances(const PatchSet& set, const PatchMethod& method, double size_px) {
  std::vector<cv::Mat> rows;
  for (std::size_t k = 0; k < set.mosaics.size(); ++k) {
    const int patches = std::min(kPatches, set.count - static_cast<int>(k) * kPatches);
    rows.push_back(method.describe(set.mosaics[k], patches, size_px));
  }
  auto row = [&](int number) {
    return rows[static_cast<std::size_t>(number / kPatches)].row(number % kPatches);
  };
  std::vector<float> distances;
  for (const PatchPair& pair : set.pairs) {
    const cv::Mat a = row(pair.first), b = row(pair.second);
    distances.push_back(static_cast<float>(distance_of_rows(a, b, method.descriptions)));
  }
  return distances;
}

double false_positive_rate(const std::vector<PatchPair>& pairs, const std::vector<float>& distances,
                           double recall) {
  std::vector<float> same;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (pairs[k].same) same.push_back(distances[k]);
  }
  if (same.empty() || same.size() == pairs.size()) return 0.0;
  std::ranges::sort(same);
  const double needed = std::ceil(recall * static_cast<double>(same.size()));
  const int last = static_cast<int>(same.size()) - 1;
  const float threshold = same[static_cast<std::size_t>(cut_within(needed - 1.0, 0, last))];
  std::size_t accepted = 0;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    accepted += !pairs[k].same && distances[k] <= threshold;
  }
  return static_cast<double>(accepted) / static_cast<double>(pairs.size() - same.size());
}

}  // namespace striate::evaluation
