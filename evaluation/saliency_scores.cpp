#include "striate/evaluation/saliency_scores.hpp"

#include <algorithm>
#include <functional>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace striate::evaluation {
namespace {

/// Thresholds are the map's values at the fixated pixels; at each, the share of fixated pixels and
/// of all other pixels that are at or above it. Trapezoids below that curve.
double auc_judd(const cv::Mat1f& salience, const cv::Mat1b& fixated) {
  std::vector<float> hits;
  std::vector<float> others;
  for (int v = 0; v < salience.rows; ++v) {
    for (int u = 0; u < salience.cols; ++u) {
      (fixated(v, u) != 0 ? hits : others).push_back(salience(v, u));
    }
  }
  if (others.empty()) return 0.5;
  std::sort(hits.begin(), hits.end(), std::greater<>());
  std::sort(others.begin(), others.end(), std::greater<>());
  double area = 0.0;
  double before_x = 0.0;
  double before_y = 0.0;
  auto step = [&](double x, double y) {
    area += 0.5 * (x - before_x) * (y + before_y);
    before_x = x;
    before_y = y;
  };
  for (std::size_t k = 0; k < hits.size(); ++k) {
    if (k + 1 < hits.size() && hits[k + 1] == hits[k]) continue;
    const auto above = std::upper_bound(others.begin(), others.end(), hits[k], std::greater<>());
    step(static_cast<double>(above - others.begin()) / static_cast<double>(others.size()),
         static_cast<double>(k + 1) / static_cast<double>(hits.size()));
  }
  step(1.0, 1.0);
  return area;
}

}  // namespace

SaliencyScores score_salience(const cv::Mat1f& salience, const std::vector<cv::Point>& fixations,
                              double blur_px) {
  if (salience.empty() || fixations.empty()) {
    throw std::invalid_argument("score_salience: needs a map and fixations");
  }
  cv::Mat1b fixated(salience.size(), uchar{0});
  cv::Mat1f density(salience.size(), 0.0F);
  for (const cv::Point& p : fixations) {
    fixated(p) = 1;
    density(p) += 1.0F;
  }
  cv::GaussianBlur(density, density, {0, 0}, blur_px);
  cv::Scalar mean, deviation, density_mean, density_deviation;
  cv::meanStdDev(salience, mean, deviation);
  cv::meanStdDev(density, density_mean, density_deviation);
  SaliencyScores scores;
  scores.auc_judd = auc_judd(salience, fixated);
  if (deviation[0] <= 1e-12) return scores;
  for (const cv::Point& p : fixations) scores.nss += (salience(p) - mean[0]) / deviation[0];
  scores.nss /= static_cast<double>(fixations.size());
  if (density_deviation[0] <= 1e-12) return scores;
  double product = 0.0;
  for (int v = 0; v < salience.rows; ++v) {
    for (int u = 0; u < salience.cols; ++u) {
      product += (salience(v, u) - mean[0]) * (density(v, u) - density_mean[0]);
    }
  }
  scores.cc =
      product / (static_cast<double>(salience.total()) * deviation[0] * density_deviation[0]);
  return scores;
}

}  // namespace striate::evaluation
