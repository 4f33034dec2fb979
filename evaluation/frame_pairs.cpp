#include "striate/evaluation/frame_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>

#include "striate/base/geometry.hpp"

namespace striate::evaluation {
namespace {

constexpr double kDegree = radians(1.0);  // a degree in radians

bool patch_fits(const cv::KeyPoint& frame, cv::Size size) {
  const double reach = 0.5 * kPatchSizes * frame.size * std::numbers::sqrt2;
  return frame.pt.x >= reach && frame.pt.y >= reach && frame.pt.x < size.width - 1 - reach &&
         frame.pt.y < size.height - 1 - reach;
}

double turn_deg(double a_deg, double b_deg) {
  return std::abs(std::remainder(a_deg - b_deg, 360.0));
}

bool agrees(const cv::KeyPoint& found, const cv::KeyPoint& wanted, const FrameTolerance& t) {
  return std::hypot(found.pt.x - wanted.pt.x, found.pt.y - wanted.pt.y) <=
             t.position_sizes * wanted.size &&
         std::abs(std::log2(found.size / wanted.size)) <= t.scale_octaves &&
         turn_deg(found.angle, wanted.angle) <= t.angle_deg;
}

}  // namespace

std::vector<cv::KeyPoint> sift_frames(const cv::Mat1b& image) {
  std::vector<cv::KeyPoint> frames;
  cv::SIFT::create()->detect(image, frames);
  std::erase_if(frames, [&](const cv::KeyPoint& k) { return !patch_fits(k, image.size()); });
  return frames;
}

cv::KeyPoint predicted(const cv::KeyPoint& frame, const cv::Matx33d& h) {
  const double x = frame.pt.x, y = frame.pt.y;
  const double w = h(2, 0) * x + h(2, 1) * y + h(2, 2);
  const double u = (h(0, 0) * x + h(0, 1) * y + h(0, 2)) / w;
  const double v = (h(1, 0) * x + h(1, 1) * y + h(1, 2)) / w;
  const double ux = (h(0, 0) - u * h(2, 0)) / w, uy = (h(0, 1) - u * h(2, 1)) / w;
  const double vx = (h(1, 0) - v * h(2, 0)) / w, vy = (h(1, 1) - v * h(2, 1)) / w;
  const double c = std::cos(frame.angle * kDegree), s = std::sin(frame.angle * kDegree);
  cv::KeyPoint result = frame;
  result.pt = {static_cast<float>(u), static_cast<float>(v)};
  result.size = static_cast<float>(frame.size * std::sqrt(std::abs(ux * vy - uy * vx)));
  result.angle = static_cast<float>(std::atan2(vx * c + vy * s, ux * c + uy * s) / kDegree);
  return result;
}

std::vector<FramePair> frame_pairs(const std::vector<cv::KeyPoint>& first,
                                   const std::vector<cv::KeyPoint>& second,
                                   const cv::Matx33d& homography, const FrameTolerance& tolerance) {
  std::vector<FramePair> pairs;
  std::vector<bool> taken(second.size(), false);
  for (const cv::KeyPoint& frame : first) {
    const cv::KeyPoint wanted = predicted(frame, homography);
    std::size_t best = second.size();
    double nearest = 0.0;
    for (std::size_t k = 0; k < second.size(); ++k) {
      if (taken[k] || !agrees(second[k], wanted, tolerance)) continue;
      const double distance =
          std::hypot(second[k].pt.x - wanted.pt.x, second[k].pt.y - wanted.pt.y);
      if (best == second.size() || distance < nearest) best = k, nearest = distance;
    }
    if (best == second.size()) continue;
    taken[best] = true;
    pairs.push_back({frame, second[best]});
  }
  return pairs;
}

std::vector<cv::Mat1b> halvings(const cv::Mat1b& image) {
  std::vector<cv::Mat1b> result = {image};
  while (std::min(result.back().cols, result.back().rows) >= 2 * kPatchSide_px) {
    cv::Mat1b half;
    // An odd last row or column is left out: pixels must stay where they are.
    const cv::Size size(result.back().cols / 2, result.back().rows / 2);
    cv::resize(result.back()(cv::Rect({0, 0}, size * 2)), half, size, 0, 0, cv::INTER_AREA);
    result.push_back(half);
  }
  return result;
}

cv::Mat1b cut_patch(const std::vector<cv::Mat1b>& halvings, const cv::KeyPoint& frame) {
  const double step = kPatchSizes * frame.size / kPatchSide_px;  // image px per patch px
  const auto level = static_cast<std::size_t>(
      std::clamp(std::lround(std::log2(step)), 0L, static_cast<long>(halvings.size()) - 1));
  const double scale = std::ldexp(1.0, static_cast<int>(level));
  const double c = std::cos(frame.angle * kDegree) * step / scale;
  const double s = std::sin(frame.angle * kDegree) * step / scale;
  const double middle = 0.5 * (kPatchSide_px - 1);
  const double u = (frame.pt.x + 0.5) / scale - 0.5, v = (frame.pt.y + 0.5) / scale - 0.5;
  const cv::Matx23d to_image(c, -s, u - c * middle + s * middle,  //
                             s, c, v - s * middle - c * middle);
  cv::Mat1b patch;
  cv::warpAffine(halvings[level], patch, to_image, {kPatchSide_px, kPatchSide_px},
                 cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_REPLICATE);
  return patch;
}

void add_pairs(const cv::Mat1b& first, const cv::Mat1b& second, std::vector<FramePair> pairs,
               std::size_t most, std::uint64_t seed, PatchSet& set) {
  cv::RNG random(seed);
  for (std::size_t k = 0; k + 1 < pairs.size(); ++k) {
    const auto rest = static_cast<unsigned>(pairs.size() - k);
    std::swap(pairs[k], pairs[k + random(rest)]);
  }
  if (pairs.size() > most) pairs.resize(most);
  const auto first_halvings = halvings(first), second_halvings = halvings(second);
  std::vector<PatchPair> numbers;
  for (const FramePair& pair : pairs) {
    const int a = set.add(cut_patch(first_halvings, pair.first));
    numbers.push_back({a, set.add(cut_patch(second_halvings, pair.second)), true});
  }
  set.pairs.insert(set.pairs.end(), numbers.begin(), numbers.end());
  const auto count = static_cast<unsigned>(pairs.size());
  for (unsigned k = 0; k < count; ++k) {
    for (int attempt = 0; attempt < 32; ++attempt) {
      const unsigned other = random(count);
      const cv::Point2f apart = pairs[k].first.pt - pairs[other].first.pt;
      if (std::hypot(apart.x, apart.y) < kPatchSizes * pairs[k].first.size) continue;
      set.pairs.push_back({numbers[k].first, numbers[other].second, false});
      break;
    }
  }
}

}  // namespace striate::evaluation
