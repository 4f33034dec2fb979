#include "striate/perception/gist/gist.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace striate::perception {
namespace {

/// Of the finest scale: a corridor's doors are some wavelengths wide at it (rtabmap_samples)
const cv::Size kGistImage_px(160, 120);
/// Fraction of a root: 1/256 is less than the code's own step
constexpr double kRootUnit = 256.0;
/// The paper's lambda with a round envelope, which is one separable filter
constexpr V1Settings kGistCells{.wavelength_px = 4.0, .gamma = 1.0};

constexpr int kCodes = 65536;       ///< codes: all of 16 bits, as V1Responses has them
constexpr int kLeastCode = -32768;  ///< code of no response, the least of 16 bits: V1Responses

/// First pixel of each part, and the end: parts differ by a pixel at most.
int part_edge(int part, int size) {
  return part * size / kGistParts;
}

}  // namespace

double gist_distance(const Gist& a, const Gist& b) {
  std::int64_t product = 0, square_a = 0, square_b = 0;
  for (std::size_t k = 0; k < a.values.size(); ++k) {
    const int x = a.values[k], y = b.values[k];
    product += static_cast<std::int64_t>(x) * y;
    square_a += static_cast<std::int64_t>(x) * x;
    square_b += static_cast<std::int64_t>(y) * y;
  }
  if (square_a == 0 || square_b == 0) return std::numbers::sqrt2;
  const double cosine = static_cast<double>(product) /
                        std::sqrt(static_cast<double>(square_a) * static_cast<double>(square_b));
  return std::sqrt(std::max(0.0, 2.0 - 2.0 * cosine));
}

GistFinder::GistFinder() : cells_(kGistCells) {
  root_.resize(kCodes);
  for (int k = 0; k < kCodes; ++k) {
    const double response = complex_response(static_cast<std::int16_t>(k + kLeastCode));
    root_[static_cast<std::size_t>(k)] =
        static_cast<std::int32_t>(std::lround(kRootUnit * std::sqrt(response)));
  }
}

void GistFinder::pool(int scale) {
  const cv::Mat1b& image = images_[static_cast<std::size_t>(scale)];
  cells_.respond(image, 0, false, responses_);
  auto* value =
      pooled_.data() + static_cast<std::ptrdiff_t>(scale) * kGistParts * kGistParts * kOrientations;
  for (int row = 0; row < kGistParts; ++row) {
    for (int column = 0; column < kGistParts; ++column) {
      const int left = part_edge(column, image.cols), right = part_edge(column + 1, image.cols);
      const int top = part_edge(row, image.rows), bottom = part_edge(row + 1, image.rows);
      for (const auto& code : responses_.code) {
        std::int64_t sum = 0;
        for (int y = top; y < bottom; ++y) {
          const std::int16_t* line = code.row(y);
          for (int x = left; x < right; ++x) {
            sum += root_[static_cast<std::size_t>(line[x] - kLeastCode)];
          }
        }
        *value++ = sum / ((right - left) * (bottom - top));
      }
    }
  }
}

Gist GistFinder::find(const cv::Mat1b& grey) {
  if (grey.empty()) throw std::invalid_argument("GistFinder: the image is empty");
  cv::resize(grey, images_[0], kGistImage_px, 0, 0, cv::INTER_AREA);
  for (std::size_t s = 1; s < images_.size(); ++s) {
    cv::resize(images_[s - 1], images_[s], images_[s - 1].size() / 2, 0, 0, cv::INTER_AREA);
  }
  for (int scale = 0; scale < kGistScales; ++scale) pool(scale);
  double square = 0.0;  // of whole numbers below 2^53: exact
  for (const std::int64_t value : pooled_) square += static_cast<double>(value * value);
  Gist gist;
  if (square == 0.0) return gist;
  const double unit = kGistLength / std::sqrt(square);
  for (std::size_t k = 0; k < pooled_.size(); ++k) {
    const long value = std::lround(unit * static_cast<double>(pooled_[k]));
    gist.values[k] = static_cast<std::uint8_t>(std::min(255L, value));
  }
  return gist;
}

}  // namespace striate::perception
